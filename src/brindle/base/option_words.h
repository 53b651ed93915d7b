/// Options of the tool in messages of programs that call them something else.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace brindle {

/// `text` with `name_of("field-smoothing")` in the place of "--field-smoothing", and so on for
/// every option that it names.
std::string with_option_names(std::string_view text,
                              const std::function<std::string(const std::string&)>& name_of);

}  // namespace brindle
