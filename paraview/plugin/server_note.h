/// What a server says to who has loaded the plugin there.
#pragma once

/// In a server that a client has connected to, on its first rank: that the client needs the plugin,
/// too. ParaView itself ends a client that lacks a class of a representation, without a remedy; and
/// a server cannot ask what its client has.
void tell_client_to_load();
