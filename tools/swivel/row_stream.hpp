#ifndef SWIVEL_COMMAND_ROW_STREAM_HPP
#define SWIVEL_COMMAND_ROW_STREAM_HPP

// The rows of a table through an operation of the library, a block at a time.

#include <string>
#include <vector>

#include "eval_block.hpp"
#include "line_reader.hpp"
#include "operations/operation.hpp"
#include "output.hpp"
#include "row_fields.hpp"

namespace swivel::command {

struct row_stream_options {
    memory_layout layout = memory_layout::soa;
    // Of the columns that are read, group by group, as the header row has them.
    std::vector<std::string> names;
    separator between = separator::of_line;
    char decimal = '.';
    bool missing_is_nan = false;  // an empty field
    bool degrees = false;         // angles are read and written in degrees
    bool pass = false;            // columns that the operation does not read are written in front of its own
};

// From the header row to the end. Memory is bounded whatever the length of the table. Bad data is thrown
// after the rows before it have been written.
template <class T>
void stream_rows(const operations::operation& operation, const operations::settings& settings,
                 const row_stream_options& options, line_reader& in, output& out);

extern template void stream_rows<float>(const operations::operation&, const operations::settings&,
                                        const row_stream_options&, line_reader&, output&);
extern template void stream_rows<double>(const operations::operation&, const operations::settings&,
                                         const row_stream_options&, line_reader&, output&);

}  // namespace swivel::command

#endif
