#nullable enable

using System;
using System.Text;

namespace NeuronMocap.Unity
{
    // Why a figure does not move. Sentences are created when something changes, not for each frame.
    public abstract partial class FigureDriver
    {
        private const string NoSource =
            "No mocap source found. Add one to the scene (GameObject > NeuronMocap > Source), or assign one to Source.";

        private const string SourceDisabled = "The source of this figure is disabled. Enable its component and its object, or assign another source.";

        private const string Idle = "The performer has stopped sending. In Axis Neuron, check the suit, or play a take.";

        [NonSerialized]
        private string _missing = string.Empty;

        [NonSerialized]
        private (PerformerChoice Choice, int Index, string Name, int Count) _missed;

        private string Explain()
        {
            if (ActiveSource == null)
                return NoSource;
            if (IsDriving)
                return _rootMotionTarget == RootMotionTarget.CharacterController && _controller == null ? NoController : _rig!.Bodies.Problem;
            if (!ActiveSource.isActiveAndEnabled)
                return SourceDisabled;
            if (ActiveSource.State != SourceState.Receiving)
                return ActiveSource.StatusMessage;

            if (Performer is null && AssignedSender is null)
                return DescribeMissing(ActiveSource);

            return Performer is { IsLive: true } ? string.Empty : Idle;
        }

        private string DescribeMissing(MocapSource source)
        {
            var missed = (_performerChoice, _performerIndex, _performerName, source.Performers.Count);
            if (_missing.Length > 0 && _missed == missed)
                return _missing;

            _missed = missed;
            var text = new StringBuilder();
            if (_performerChoice == PerformerChoice.ByName)
                text.Append("No performer is called \"").Append(_performerName).Append("\". Change Performer Name");
            else
                text.Append("No performer ").Append(_performerIndex).Append(". Change Performer Index");

            text.Append(source.Performers.Count == 0 ? "; none has sent a frame yet" : " to one of these: ");
            for (int i = 0; i < source.Performers.Count; i++)
                text.Append(i > 0 ? ", " : string.Empty).Append(source.Performers[i]);

            return _missing = text.Append('.').ToString();
        }
    }
}
