/// A server's message after loading the plugin.
#pragma once

/// On the first rank of a server with a client, asks to load the plugin in the client, too.
/// Otherwise, ParaView ends a client that lacks a representation's class, without a remedy; a
/// server cannot query its client's plugins.
void tell_client_to_load();
