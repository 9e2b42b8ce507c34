#include "row_stream.hpp"

#include <algorithm>
#include <limits>
#include <numbers>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "failure.hpp"
#include "number_text.hpp"
#include "progress.hpp"
#include "row_fields.hpp"
#include "swivel/clip/text.hpp"

namespace swivel::command {

namespace {

constexpr std::size_t rows_in_block = std::size_t{1} << 16;
constexpr std::size_t passed_bytes_in_block = std::size_t{1} << 24;

// Which column of the operation each field of a row is; nothing for a field that is passed.
using column_map = std::vector<std::optional<std::size_t>>;

std::string joined(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : " ") + name;
    return text;
}

std::string counted_fields(std::size_t count) {
    return std::to_string(count) + (count == 1 ? " field" : " fields");
}

// Of each column, whether it is an angle.
std::vector<bool> angles_of(const std::vector<operations::group>& groups) {
    std::vector<bool> angles;
    for (const operations::group& g : groups)
        angles.resize(angles.size() + operations::stream_names(g).size(),
                      g.meaning == operations::meaning::angle);
    return angles;
}

constexpr double radians_of_a_degree = std::numbers::pi / 180;

template <class T>
class row_stream {
public:
    row_stream(const operations::operation& operation, const operations::settings& settings,
               const row_stream_options& options, line_reader& in, output& out)
        : settings_(settings),
          options_(options),
          in_(in),
          out_(out),
          groups_(operation.groups(settings)),
          inputs_(groups_.in, options.layout, rows_in_block),
          outputs_(groups_.out, options.layout, rows_in_block),
          run_(operation.library.as<T>()) {
        if (!options.degrees) return;
        degrees_in_ = angles_of(groups_.in);
        degrees_out_ = angles_of(groups_.out);
    }

    void run() {
        progress bar("reading " + in_.name(), in_.total_bytes(), !out_.is_terminal());
        read_header();
        for (bool more = true; more;) {
            try {
                more = read_block();
            } catch (const bad_data&) {
                write_block();
                out_.flush();
                throw;
            }
            write_block();
            bar.reached(in_.bytes_read());
        }
    }

private:
    [[noreturn]] void fail(std::size_t column, std::string_view what, std::string_view expected) const {
        throw bad_data(in_.name(), in_.line_number(), column, what, expected);
    }

    // False at the end of the input.
    bool next_row() {
        while (in_.next(line_)) {
            const std::optional<field_fault> fault = split_row(line_, fields_, options_.between);
            if (fault) fail(fault->column, fault->what, std::string(fault->expected) + hint());
            if (!fields_.empty()) return true;
        }
        return false;
    }

    void read_header() {
        const std::vector<std::string>& wanted = options_.names;
        const std::vector<std::string> written = operations::stream_names(groups_.out);
        const std::string expected = "a header row with the columns " + joined(wanted);
        if (!next_row()) throw bad_data(in_.name(), 1, 1, "the input is empty", expected);

        // By name, since a header of a megabyte has a hundred thousand.
        std::unordered_map<std::string_view, std::size_t> places;
        for (std::size_t i = 0; i < wanted.size(); ++i) places.emplace(wanted[i], i);
        std::unordered_set<std::string> seen;
        std::string header;
        for (const field& f : fields_) {
            std::string name = unquoted(f);
            const auto place = places.find(name);
            const bool is_read = place != places.end();
            if (!is_read && !options_.pass)
                fail(f.column,
                     name.empty() ? "a column without a name" : "unknown column " + clip::quoted(name),
                     expected + " (--pass copies other ones)" + hint());
            // Any number of columns may have none, as the index of a data frame.
            if (!name.empty() && seen.count(name) != 0)
                fail(f.column, "the column " + clip::quoted(name) + " is there twice", "each column once");
            if (!is_read && std::find(written.begin(), written.end(), name) != written.end())
                fail(f.column, "the column " + clip::quoted(name) + " cannot be passed",
                     "no name of a column that is written: " + joined(written));
            map_.push_back(is_read ? std::optional(place->second) : std::nullopt);
            if (!is_read) {
                append_field(header, name);
                header += ',';
            }
            seen.insert(std::move(name));
        }
        for (const std::string& name : wanted)
            if (seen.count(name) == 0)
                fail(line_.size() + 1, "the column " + clip::quoted(name) + " is missing", expected + hint());
        for (const std::string& name : written) header += name + (name == written.back() ? "\n" : ",");
        out_.write(header);
        in_header_ = false;
    }

    // Where semicolons seem to separate the header row.
    [[nodiscard]] const char* hint() const {
        const bool semicolons =
            in_header_ && options_.between == separator::of_line &&
            std::count(line_.begin(), line_.end(), ';') > std::count(line_.begin(), line_.end(), ',');
        return semicolons
                   ? "; --separator ';' reads fields between semicolons, --decimal ',' numbers with a comma"
                   : "";
    }

    // False at the end of the input.
    bool read_block() {
        while (rows_ < rows_in_block && passed_.size() < passed_bytes_in_block) {
            if (!next_row()) return false;
            read_row();
        }
        return true;
    }

    void read_row() {
        const std::size_t expected = map_.size();
        if (fields_.size() != expected) {
            const bool is_short = fields_.size() < expected;
            fail(is_short ? line_.size() + 1 : fields_[expected].column,
                 (is_short ? "row too short: " : "row too long: ") + counted_fields(fields_.size()),
                 std::to_string(expected) + ", as in the header row");
        }
        const std::size_t passed_before = passed_.size();
        for (std::size_t i = 0; i < expected; ++i) {
            const field& f = fields_[i];
            if (!map_[i]) {
                append_field(passed_, f);
                passed_ += ',';
                continue;
            }
            const clip::parsed<T> number = parse(f.text);
            if (!number.fault.empty()) {
                passed_.resize(passed_before);
                if (f.text.empty())
                    fail(f.column, "an empty field", "a number (--missing nan reads it as NaN)");
                fail(f.column, clip::quoted(f.text) + " " + std::string(number.fault),
                     options_.decimal == '.' ? "a number" : "a number with a decimal comma");
            }
            const bool is_degrees = !degrees_in_.empty() && degrees_in_[*map_[i]];
            inputs_.at(rows_, *map_[i]) =
                is_degrees ? static_cast<T>(radians_of_a_degree * double{number.value}) : number.value;
        }
        passed_ends_.push_back(passed_.size());
        ++rows_;
    }

    [[nodiscard]] clip::parsed<T> parse(std::string_view text) {
        if (text.empty() && options_.missing_is_nan) return {std::numeric_limits<T>::quiet_NaN(), {}};
        if (options_.decimal == '.') return parse_real<T>(text);
        if (text.find('.') != std::string_view::npos) return {T{0}, "is not a number"};
        with_point_ = text;
        std::replace(with_point_.begin(), with_point_.end(), options_.decimal, '.');
        return parse_real<T>(with_point_);
    }

    void write_block() {
        if (rows_ == 0) return;
        const operations::block<const T> in(inputs_.view(rows_));
        if (const swivel::status s = run_(settings_, in, outputs_.view(rows_)); s != swivel::status::ok)
            throw bad_usage(std::string("the library refused: ") + swivel::name(s));

        text_.clear();
        std::size_t passed_from = 0;
        for (std::size_t row = 0; row < rows_; ++row) {
            text_.append(passed_, passed_from, passed_ends_[row] - passed_from);
            passed_from = passed_ends_[row];
            for (std::size_t column = 0; column < outputs_.columns(); ++column) {
                if (column > 0) text_ += ',';
                const bool is_degrees = !degrees_out_.empty() && degrees_out_[column];
                const T value = outputs_.at(row, column);
                append_number(text_,
                              is_degrees ? static_cast<T>(double{value} / radians_of_a_degree) : value);
            }
            text_ += '\n';
        }
        out_.write(text_);
        rows_ = 0;
        passed_.clear();
        passed_ends_.clear();
    }

    const operations::settings& settings_;
    const row_stream_options& options_;
    line_reader& in_;
    output& out_;
    operations::groups groups_;
    eval_block<T> inputs_, outputs_;
    operations::function<T> run_;
    std::vector<bool> degrees_in_, degrees_out_;  // of each column; none without --degrees
    column_map map_;
    bool in_header_ = true;

    std::string_view line_;
    std::vector<field> fields_;
    std::size_t rows_ = 0;
    std::string with_point_;
    std::string passed_;  // of all rows of the block, each field with its comma
    std::vector<std::size_t> passed_ends_;
    std::string text_;
};

}  // namespace

template <class T>
void stream_rows(const operations::operation& operation, const operations::settings& settings,
                 const row_stream_options& options, line_reader& in, output& out) {
    row_stream<T>(operation, settings, options, in, out).run();
}

template void stream_rows<float>(const operations::operation&, const operations::settings&,
                                 const row_stream_options&, line_reader&, output&);
template void stream_rows<double>(const operations::operation&, const operations::settings&,
                                  const row_stream_options&, line_reader&, output&);

}  // namespace swivel::command
