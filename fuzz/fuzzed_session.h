/// Sessions: documents, lists of commands, and operations at random on a live pattern.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace brindle::fuzz {

/// Each throws Error for what is refused, and BrokenPromise.
void run_session(std::span<const std::uint8_t> bytes);
void run_commands(std::span<const std::uint8_t> bytes);

/// Opens shapes, gives and clears options of the table, draws strokes, drags, undoes and redoes,
/// and makes patterns in between, some of which are cancelled.
void run_operations(std::span<const std::uint8_t> bytes);

/// Of a session that has something of everything.
std::string session_text();

}  // namespace brindle::fuzz
