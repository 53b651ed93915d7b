#include "server_note.h"

#include <vtkOutputWindow.h>
#include <vtkProcessModule.h>

void tell_client_to_load() {
  const auto process = vtkProcessModule::GetProcessType();
  const bool is_server = process == vtkProcessModule::PROCESS_SERVER ||
                         process == vtkProcessModule::PROCESS_DATA_SERVER ||
                         process == vtkProcessModule::PROCESS_RENDER_SERVER;
  vtkProcessModule* module = vtkProcessModule::GetProcessModule();
  if (!is_server || module == nullptr || module->GetPartitionId() != 0) return;
  vtkOutputWindowDisplayText(
      "The server has loaded Brindle. Load it in the client as well, in Python by "
      "LoadPlugin(FILE, remote=False), before anything is shown: without, ParaView ends the client "
      "with \"Failed to create 'vtkBrindleStripesRepresentation'\".\n");
}
