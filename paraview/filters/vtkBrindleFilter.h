/// What Brindle's filters share: the surface, the waves and the pattern, kept from one run to the
/// next.
#pragma once

#include <functional>
#include <memory>

#include <vtkPolyDataAlgorithm.h>

#include "BrindleFiltersModule.h"  // export macro

/// Takes polygons, or the surface of grids and of blocks, and lays waves over it. Input array 0 is
/// the field, array 1 the frequency, array 2 weights; all may belong to points or cells. The ranks
/// of VTK's global controller have one surface and run together.
class BRINDLEFILTERS_EXPORT vtkBrindleFilter : public vtkPolyDataAlgorithm {
 public:
  vtkTypeMacro(vtkBrindleFilter, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Where directions come from, in the order of FieldSource: 0 smooth, 1 curvature, 2 direction,
  /// 3 array.
  vtkSetClampMacro(Field, int, 0, 3);
  vtkGetMacro(Field, int);
  /// Of a curvature field, 0: of larger, 1: of smaller absolute curvature.
  vtkSetClampMacro(CurvatureDirection, int, 0, 1);
  vtkGetMacro(CurvatureDirection, int);
  /// Of an array of tensors, in the order of TensorAxis: 0 major, 1 minor, 2 largest absolute, 3
  /// and 4 major and minor of the part within the surface.
  vtkSetClampMacro(TensorAxis, int, 0, 4);
  vtkGetMacro(TensorAxis, int);
  /// Of a direction field: any vector but zero.
  vtkSetVector3Macro(Direction, double);
  vtkGetVector3Macro(Direction, double);
  /// Whether stripes run along the field, and not across it.
  vtkSetMacro(Along, bool);
  vtkGetMacro(Along, bool);
  /// An array is seen at the scale of so many periods of the stripes, without what is finer, and
  /// with its holes filled; 0 to 100, 0: as it is given. Input array 2, if there is one, says how
  /// much data count.
  vtkSetMacro(FieldDetail, double);
  vtkGetMacro(FieldDetail, double);
  /// The same of an array of frequencies.
  vtkSetMacro(FrequencyDetail, double);
  vtkGetMacro(FrequencyDetail, double);
  /// With FieldDetail: how much the field of the time before counts beside the data; 0 or above.
  vtkSetMacro(FieldMemory, double);
  vtkGetMacro(FieldMemory, double);
  /// With FieldDetail and FrequencyDetail: how far holes are filled, in periods; 0 or above.
  vtkSetMacro(FillPeriods, double);
  vtkGetMacro(FillPeriods, double);
  /// With FieldDetail: whether vectors have a sign, so that those that face each other cancel.
  vtkSetMacro(FieldArrows, bool);
  vtkGetMacro(FieldArrows, bool);
  /// With FieldDetail: pairs of singularities are undone until at most so many are left; -1: all
  /// stay.
  vtkSetClampMacro(FieldSingularities, int, -1, 1000000);
  vtkGetMacro(FieldSingularities, int);
  /// Degrees by which the field is turned about the normals.
  vtkSetMacro(Rotate, double);
  vtkGetMacro(Rotate, double);

  /// Degrees by which an edge bends that is a crease, along which each side has stripes of its own:
  /// 0 to 180, 180: none. Over several ranks there are none.
  vtkSetMacro(CreaseAngle, double);
  vtkGetMacro(CreaseAngle, double);

  /// Where frequencies come from, in the order of FrequencySource: 0 Stripes, 1 Frequency, 2 an
  /// array, 3 Stripes times a factor that follows an array.
  vtkSetClampMacro(FrequencySource, int, 0, 3);
  vtkGetMacro(FrequencySource, int);
  /// Stripes along the diagonal of the bounding box; above 0.
  vtkSetMacro(Stripes, double);
  vtkGetMacro(Stripes, double);
  /// Stripes per unit length; above 0.
  vtkSetMacro(Frequency, double);
  vtkGetMacro(Frequency, double);
  /// Factors for the smallest and the largest number of the array.
  vtkSetVector2Macro(FrequencyRange, double);
  vtkGetVector2Macro(FrequencyRange, double);
  /// How far frequencies may yield, so that fewer stripes begin or end; 0 or above.
  vtkSetMacro(Slack, double);
  vtkGetMacro(Slack, double);
  /// How near a pattern stays to that of the time before; 0: each by itself.
  vtkSetMacro(TimeAnchor, double);
  vtkGetMacro(TimeAnchor, double);

  /// How many times a surface was derived, a solver was built, and a pattern followed the one of
  /// the time before.
  int GetSurfacesMade() const;
  int GetSolversMade() const;
  int GetPatternsFollowed() const;
  /// Milliseconds that the last pattern took to be solved.
  double GetSolveMilliseconds() const;

  vtkBrindleFilter(const vtkBrindleFilter&) = delete;
  void operator=(const vtkBrindleFilter&) = delete;

 protected:
  /// What one run hands to `Fill`, in the library's words.
  struct Run;

  vtkBrindleFilter();
  ~vtkBrindleFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputs,
                  vtkInformationVector* outputs) override;

  /// Makes the output of a run. Over several ranks all are in it together: what one of them throws,
  /// all throw. May throw brindle::Error; the output is then emptied.
  virtual void Fill(Run& run, vtkPolyData* output) = 0;

 private:
  struct State;

  bool Prepare(vtkDataObject* input, Run& run);
  void Fail(vtkPolyData* output, const char* message);
  void EndIfOthersWait(const Run& run);
  void WarnOf(const Run& run);

  int Field = 0;
  int CurvatureDirection = 0;
  int TensorAxis = 0;
  double Direction[3] = {0, 0, 1};
  bool Along = false;
  double FieldDetail = 0;
  double FillPeriods = 2;
  double FrequencyDetail = 0;
  double FieldMemory = 0;
  bool FieldArrows = false;
  int FieldSingularities = -1;
  double Rotate = 0;
  double CreaseAngle = 40;
  int FrequencySource = 0;
  double Stripes = 40;
  double Frequency = 1;
  double FrequencyRange[2] = {0.4, 2.5};
  double Slack = 0;
  double TimeAnchor = 0.025;
  bool Stopped = false;  // the last run was told to stop
  std::unique_ptr<State> Internals;
};
