/// The icons of the filters, for a client with windows.
#pragma once

/// Loads BrindleIcons, which lies beside the plugin, into a process that has Qt; elsewhere, and
/// where it was not built, does nothing.
void load_client_icons();
