#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "arguments.hpp"
#include "commands.hpp"
#include "failure.hpp"
#include "joint_curves.hpp"
#include "near_names.hpp"
#include "number_text.hpp"
#include "output.hpp"
#include "progress.hpp"
#include "row_fields.hpp"
#include "swivel/clip/read.hpp"
#include "swivel/clip/text.hpp"
#include "text_table.hpp"

namespace swivel::command {

namespace {

constexpr std::string_view csv_header =
    "frame,time,joint,sx,sy,sz,sw,tx,ty,tz,tw,twist_degrees,swing_degrees\n";

struct decompose_arguments {
    std::string clip;
    std::vector<std::string> joints;
    axis_argument axis = automatic_axis{};
    std::optional<std::string> out;
    clip::read_options reading;
    std::optional<swivel::isa> isa;
    swivel::options options;
};

struct joint_axis {
    swivel::twist_axis<double> axis = swivel::axis::z;
    std::string shown;
    std::string_view rule;
};

std::string place(const std::string& file, const clip::diagnostic& d) {
    if (d.line == 0) return file + ": ";
    return file + ":" + std::to_string(d.line) + ":" + std::to_string(d.column) + ": ";
}

clip::clip read_clip(const decompose_arguments& arguments, const std::string& shown_name) {
    clip::read_result result;
    {
        const progress bar("reading " + shown_name, 0);
        result = clip::read_bvh_file(arguments.clip, arguments.reading);
    }
    for (const clip::diagnostic& w : result.warnings)
        std::cerr << place(shown_name, w) << "warning: " << w.what << ", expected " << w.expected << "\n";
    if (result.warnings_left_out != 0)
        std::cerr << shown_name << ": warning: " << result.warnings_left_out << " more like these\n";
    if (!result)
        throw bad_data(place(shown_name, result.error) + result.error.what + ", expected " +
                       result.error.expected);
    return std::move(*result.value);
}

bad_usage unknown_joint(const std::string& wanted, const clip::skeleton& s, const std::string& file) {
    std::vector<std::string_view> names;
    for (const clip::joint& j : s.joints) names.push_back(j.name);
    std::vector<std::string_view> near = near_names(wanted, names);
    std::string message = file + " has no joint " + clip::quoted(wanted);
    if (near.empty()) {
        message += ", it begins with";
        near.assign(names.begin(),
                    names.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(5, names.size())));
    } else {
        message += ", near names are";
    }
    for (const std::string_view name : near) message += " " + clip::quoted(name);
    return bad_usage(message);
}

// In the order in which they were asked for, each once; all of them when none was.
std::vector<std::size_t> chosen_joints(const decompose_arguments& arguments, const clip::skeleton& s,
                                       const std::string& file) {
    std::vector<std::size_t> chosen;
    if (arguments.joints.empty()) {
        for (std::size_t i = 0; i < s.joints.size(); ++i) chosen.push_back(i);
        return chosen;
    }
    for (const std::string& name : arguments.joints) {
        const std::optional<std::size_t> index = clip::find_joint(s, name);
        if (!index) throw unknown_joint(name, s, file);
        if (std::find(chosen.begin(), chosen.end(), *index) == chosen.end()) chosen.push_back(*index);
    }
    return chosen;
}

std::string shown_direction(double x, double y, double z) {
    return fixed_decimals(x, 3) + "," + fixed_decimals(y, 3) + "," + fixed_decimals(z, 3);
}

class axis_choice {
public:
    axis_choice(const axis_argument& given, const clip::skeleton& s) : given_(given) {
        if (std::holds_alternative<automatic_axis>(given)) directions_ = clip::bone_directions(s);
    }

    [[nodiscard]] joint_axis of(std::size_t joint_index) const {
        if (const auto* const coordinate = std::get_if<swivel::axis>(&given_)) {
            constexpr const char* names[] = {"x", "y", "z"};
            return {*coordinate, names[static_cast<std::size_t>(*coordinate)], "given"};
        }
        if (const auto* const vector = std::get_if<operations::axis_vector>(&given_)) {
            const swivel::vec3<double>& v = vector->f64;
            const double largest = std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
            const double length = std::hypot(v.x / largest, v.y / largest, v.z / largest);
            return {v,
                    shown_direction(v.x / largest / length, v.y / largest / length, v.z / largest / length),
                    "given"};
        }
        const clip::bone_direction& bone = directions_[joint_index];
        const clip::vec3& d = bone.direction;
        return {d, shown_direction(d.x, d.y, d.z), clip::name(bone.rule)};
    }

private:
    const axis_argument& given_;
    std::vector<clip::bone_direction> directions_;
};

void write_curves(const joint_curves& curves, const std::string& name, double frame_time, output& csv) {
    constexpr std::size_t block = std::size_t{1} << 16;
    std::string joint;
    append_field(joint, name);
    std::string rows;
    for (std::size_t frame = 0; frame < curves.sx.size(); ++frame) {
        rows += std::to_string(frame);
        rows += ',';
        append_number(rows, static_cast<double>(frame) * frame_time);
        rows += ',';
        rows += joint;
        for (const std::vector<double>* const curve :
             {&curves.sx, &curves.sy, &curves.sz, &curves.sw, &curves.tx, &curves.ty, &curves.tz, &curves.tw,
              &curves.twist_degrees, &curves.swing_degrees}) {
            rows += ',';
            append_number(rows, (*curve)[frame]);
        }
        rows += '\n';
        if (rows.size() >= block) {
            csv.write(rows);
            rows.clear();
        }
    }
    csv.write(rows);
}

std::vector<std::string> summary_row(const std::string& name, const joint_axis& axis,
                                     const joint_summary& s) {
    std::vector<std::string> row = {shown_in_table(name), axis.shown, std::string(axis.rule)};
    if (s.frames == 0) {
        row.resize(10, "-");
        return row;
    }
    for (const double degrees : {s.twist_min, s.twist_max, s.swing_min, s.swing_max})
        row.push_back(fixed_decimals(degrees, 2));
    row.push_back(std::to_string(s.near_pole));
    row.push_back(s.frames > 1 ? fixed_decimals(s.jump, 2) : "-");
    row.push_back(s.frames > 1 ? std::to_string(s.jump_frame) : "-");
    return row;
}

text_table empty_table() {
    using enum alignment;
    return text_table({{"joint", left},
                       {"axis", left},
                       {"from", left},
                       {"twist min", right},
                       {"twist max", right},
                       {"swing min", right},
                       {"swing max", right},
                       {"near pole", right},
                       {"twist jump", right},
                       {"at frame", right}});
}

std::string headline(const std::string& file, const clip::clip& c, const swivel::options& options) {
    const auto counted = [](std::size_t count, const char* noun) {
        return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
    };
    std::string text =
        file + ": " + counted(c.skeleton.joints.size(), "joint") + ", " + counted(c.frames, "frame") + " of ";
    append_number(text, c.frame_time);
    text += " s; q = ";
    text += options.order == swivel::product::swing_twist ? "swing twist" : "twist swing";
    text += options.accuracy == swivel::precision::fast ? ", fast on " : ", reproducible on ";
    text += swivel::name(swivel::active_isa());
    return text + "\n\n";
}

constexpr std::string_view legend =
    "\n"
    "Angles in degrees: twist in [-180, 180], swing in [0, 180].\n"
    "axis: in the frame of the joint; from: what gave it, see --help.\n"
    "near pole: frames with a swing beyond 179 degrees, where the twist is ill conditioned.\n"
    "twist jump: the largest change from one frame to the next, the shorter way round; frames count from "
    "0.\n";

void decompose_clip(const decompose_arguments& arguments) {
    if (arguments.reading.strict && arguments.reading.salvage)
        throw bad_usage("--strict and --salvage contradict each other");
    if (arguments.out) require_other_file(arguments.clip, *arguments.out);
    select_isa(arguments.isa);
    const std::string shown_name = arguments.clip == "-" ? "<stdin>" : arguments.clip;
    const clip::clip c = read_clip(arguments, shown_name);
    const std::vector<std::size_t> joints = chosen_joints(arguments, c.skeleton, shown_name);
    const axis_choice axes(arguments.axis, c.skeleton);

    std::optional<output> csv;
    if (arguments.out) csv.emplace(*arguments.out);
    if (csv) csv->write(csv_header);

    text_table table = empty_table();
    {
        progress bar("factoring " + shown_name, joints.size(), !csv || !csv->is_terminal());
        joint_curves curves;
        for (std::size_t i = 0; i < joints.size(); ++i) {
            const std::string& name = c.skeleton.joints[joints[i]].name;
            const joint_axis axis = axes.of(joints[i]);
            factor_joint(c, joints[i], axis.axis, arguments.options, curves);
            table.add(summary_row(name, axis, summarize(curves)));
            if (csv) write_curves(curves, name, c.frame_time, *csv);
            bar.reached(i + 1);
        }
    }
    if (csv) csv->commit();

    const std::string summary =
        headline(shown_name, c, arguments.options) + table.text() + std::string(legend);
    if (csv && csv->is_standard_output()) {
        std::cerr << summary;
    } else {
        output standard_output("-");
        standard_output.write(summary);
        standard_output.commit();
    }
}

constexpr const char* footer =
    "Summary: one row a joint with the range of twist and swing, the number of frames near the pole (a\n"
    "swing beyond 179 degrees, where the twist is ill conditioned), and the largest change of the twist\n"
    "from one frame to the next, the shorter way round.\n\n"
    "--axis auto, and what the summary calls it:\n"
    "  child             the offset of the only child\n"
    "  mean of children  the mean of the offsets of several children\n"
    "  end site          no child: the offset of the joint's End Site\n"
    "  parent            neither: the axis of the parent\n"
    "  none              nothing gives a direction: y\n\n"
    "--out: a header row, then one row for each joint and frame, all frames of one joint before the next:\n"
    "  frame,time,joint,sx,sy,sz,sw,tx,ty,tz,tw,twist_degrees,swing_degrees\n"
    "Frames count from 0, time is in seconds. tw is never negative, so that twist_degrees is in [-180, 180]\n"
    "and the product of the factors is the joint's rotation as q or -q. With `--out -` the summary goes to\n"
    "standard error.\n\n"
    "Examples:\n"
    "  swivel decompose walk.bvh\n"
    "  swivel decompose walk.bvh --joint LeftArm --joint RightArm --out arms.csv\n"
    "  swivel decompose walk.bvh --axis 1,0,0 --product twist-swing --out - > walk.csv\n"
    "  cat walk.bvh | swivel decompose - --strict\n"
    "  swivel decompose cut-off.bvh --salvage";

}  // namespace

void add_decompose(command_line program) {
    const auto arguments = std::make_shared<decompose_arguments>();
    command_line line = program.add_command(
        "decompose", "Factors the joint rotations of a BVH clip into swing and twist; summary and table");
    line.add_operand("CLIP", arguments->clip, "BVH file, - for standard input", true);
    line.add_texts("--joint", "NAME", arguments->joints,
                   "Name of a joint, once for every joint; default: all");
    add_axis(
        line, [arguments](const axis_argument& given) { arguments->axis = given; }, axis_words::automatic);
    add_product(line, arguments->options.order);
    line.add_value(
        "--out", "FILE.csv", [arguments](const std::string& given) { arguments->out = given; },
        "File for the factors in every frame, - for standard output");
    line.add_flag("--strict", arguments->reading.strict, "What the reader would warn of is an error");
    line.add_flag("--salvage", arguments->reading.salvage,
                  "Read the whole rows of a clip that was cut off or damaged, and say how many of how many");
    add_precision(line, arguments->options.accuracy);
    add_isa(line, arguments->isa);
    add_pole_threshold(line, arguments->options.pole_threshold);
    line.set_footer(footer);
    line.set_action([arguments] { decompose_clip(*arguments); });
}

}  // namespace swivel::command
