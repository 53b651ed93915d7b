/// The icons of the filters, for clients with windows.
#pragma once

/// Loads BrindleIcons from the plugin's folder in processes with Qt; does nothing elsewhere or if
/// it was not built.
void load_client_icons();
