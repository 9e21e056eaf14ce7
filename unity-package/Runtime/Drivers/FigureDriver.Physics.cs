#nullable enable

using System;
using NeuronMocap.Retargeting;
using UnityEngine;
using Quaternion = UnityEngine.Quaternion;
using Vector3 = UnityEngine.Vector3;

namespace NeuronMocap.Unity
{
    // Moving the figure in physics steps.
    public abstract partial class FigureDriver
    {
        [NonSerialized]
        private readonly StepClock _stepClock = new StepClock();

        [NonSerialized]
        private readonly StepSampler _stepSampler = new StepSampler();

        [NonSerialized]
        private bool _isStep;

        internal FigureRig? FindRig(out string problem)
        {
            problem = string.Empty;
            return _rig ?? CreateRig(out problem);
        }

        // The transform that carries the figure, or null if there is no figure.
        internal Transform? FindHips()
        {
            Transform? hips = FindRig(out _) is { } rig ? rig.Nodes[rig.Target.HipsNode] : null;
            return hips != null ? hips : null;
        }

        // In a physics step, the place that the bone is moving to. In play mode, a faulty figure is looked for by the driver only, and not in every frame.
        internal bool TryGetBonePose(HumanoidBone bone, out Vector3 position, out Quaternion rotation)
        {
            (position, rotation) = (Vector3.zero, Quaternion.identity);
            if (!((Application.isPlaying ? _rig : FindRig(out _)) is { } rig) || !(rig.Target.GetNode(bone) is var node && node >= 0) || rig.Nodes[node] == null)
                return false;
            if (_driveTime == DriveTime.Physics && Time.inFixedTimeStep && _hasPose && !IsPosed)
                return rig.Bodies.TryGetTarget(node, out position, out rotation);

            (position, rotation) = (rig.Nodes[node].position, rig.Nodes[node].rotation);
            return true;
        }

        private void FixedUpdate()
        {
            if (_driveTime != DriveTime.Physics)
                return;

            _isStep = true;
            try
            {
                Drive();
            }
            finally
            {
                _isStep = false;
            }

            if (Performer is null)
                EndSteps();
        }

        private void FollowClock()
        {
            // A file follows the time of the game.
            bool isFile = ActiveSource is { Kind: SourceKind.BvhFile or SourceKind.Recording };
            if (Performer is { } performer)
                _stepClock.Follow(Time.timeAsDouble, performer.Time, isFile ? 1 : Time.timeScale);
        }

        private void EndSteps()
        {
            _stepSampler.Release();
            _stepClock.Reset();
        }

        // The time of the pose on the source's clock.
        private double TimeOf(Performer performer) =>
            _isStep && _stepClock.IsStarted ? _stepClock.ToSource(Time.fixedTimeAsDouble) : performer.Time;

        private void Write(FigureRig rig, float weight)
        {
            if (_isStep)
            {
                rig.Bodies.Write(rig.Pose, weight);
                return;
            }

            EndSteps();
            rig.Bodies.End();
            rig.Writer.Write(rig.Pose, weight);
        }
    }
}
