"""What public headers declare at the level of the namespace: functions and types."""
import re

TYPE = re.compile(r"\s*(?:template\s*<[^>]*>\s*)?(?:struct|class|enum class)\s+(?:BRINDLE_EXPORT\s+)?(\w+)")
FUNCTION = re.compile(r"\b([a-z]\w*)\s*\(")
NO_FUNCTION = re.compile(r"\s*(?:using|extern|friend|inline constexpr|constexpr)\b")


def functions_and_types(text):
    """Of a header's text, in its order, each once. Bodies are skipped by their braces."""
    text = re.sub(r"(?m)//.*|^\s*#.*$", "", text)
    functions, types, depth, seen = [], [], 0, ""
    for character in text:
        if character == "{":
            depth += 1
            if depth == 2 and (match := TYPE.match(seen)):
                types.append(match[1])
            elif depth == 2 and (match := FUNCTION.search(seen)):
                functions.append(match[1])
            if depth == 1:
                seen = ""
        elif character == "}":
            depth -= 1
            if depth == 1:
                seen = ""
        elif depth == 1:
            seen += character
            if character == ";":
                match = FUNCTION.search(seen)
                if match and not NO_FUNCTION.match(seen):
                    functions.append(match[1])
                seen = ""
    return list(dict.fromkeys(functions)), list(dict.fromkeys(types))
