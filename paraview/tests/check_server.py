"""Checks the plugin between a client and a server: pvpython check_server.py PLUGIN

Starts pvserver and connects to it. Exits with 1 if anything is not as it should be.
"""
import os
import shutil
import socket
import subprocess
import sys
from paraview import simple as pv
from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow

failures = 0


def check(good, what):
    global failures
    failures += not good
    print(("ok      " if good else "WRONG   ") + what, flush=True)


def start_server():
    """A server on a free port, and that port."""
    with socket.socket() as probe:
        probe.bind(("localhost", 0))
        port = probe.getsockname()[1]
    server = subprocess.Popen([shutil.which("pvserver"), f"--server-port={port}"], text=True,
                              stdout=subprocess.PIPE)
    for line in server.stdout:
        if "Accepting" in line:
            return server, port
    raise RuntimeError("pvserver does not start")


def words_of(work):
    """ParaView's output meanwhile, on both sides."""
    said, window = vtkStringOutputWindow(), vtkOutputWindow.GetInstance()
    vtkOutputWindow.SetInstance(said)
    work()
    vtkOutputWindow.SetInstance(window)
    return said.GetOutput()


def check_both_sides(plugin, port):
    pv.Connect("localhost", port)
    said = words_of(lambda: pv.LoadPlugin(plugin, remote=True, ns=globals()))
    check("remote=False" in said, f"a server says that the client needs the plugin, too: {said.strip()}")
    pv.LoadPlugin(plugin, remote=False, ns=globals())
    stripes = BrindleStripes(Input=pv.Sphere(ThetaResolution=60, PhiResolution=60), Stripes=12)
    display = pv.Show(stripes, pv.CreateView("RenderView"))
    pv.Render()
    check(display.Representation == "Brindle Stripes", "loaded on both sides, stripes are drawn as such")


def main(plugin):
    server, port = start_server()
    try:
        check_both_sides(plugin, port)
        pv.Disconnect()
    finally:
        server.kill()  # which would wait for another client, or tell at length how it was ended
        server.wait()


main(os.path.abspath(sys.argv[1]))
print("something is wrong" if failures else "all is well", flush=True)
os._exit(1 if failures else 0)  # what a client says at its end, whose server is gone, is not checked
