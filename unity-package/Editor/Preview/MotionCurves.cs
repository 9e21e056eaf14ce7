#nullable enable

using System;
using System.Collections.Generic;
using NeuronMocap.Motion;
using NeuronMocap.Skeleton;
using UnityEngine;
using Vector3 = System.Numerics.Vector3;

namespace NeuronMocap.Unity.EditorTools
{
    // The turn of a bone over time, as it arrives and as it is shown. Points have X in seconds and Y in degrees. Turns are about the axis about which
    // the bone moves most.
    internal sealed class MotionCurves
    {
        // A curve begins when the buffer knows the rhythm of the stream, and the filters have started.
        public const double Warmup = 1; // s

        private const double ShownRate = 60; // frames/s

        private readonly IReadOnlyList<(double Time, BoneTransform[] Pose)> _frames;
        private readonly int _bone;
        private readonly System.Numerics.Quaternion _first;
        private readonly Vector3 _axis;

        public MotionCurves(MotionHistory history, Bone bone)
        {
            _frames = history.Frames;
            _bone = (int)bone;
            _first = _frames.Count > 0 ? _frames[0].Pose[_bone].Rotation : System.Numerics.Quaternion.Identity;
            _axis = FindAxis();
        }

        private double Start => _frames.Count > 0 ? _frames[0].Time + Warmup : 0;

        // As it arrives.
        public List<Vector2> Received()
        {
            var points = new List<Vector2>(_frames.Count);
            foreach ((double time, BoneTransform[] pose) in _frames)
                Add(points, time, pose);

            return points;
        }

        // As the source shows it at 60 frames per second. late: the number of frames that came too late to be shown at their time.
        public List<Vector2> Resampled(in SamplingSettings settings, out long late)
        {
            var points = new List<Vector2>();
            PoseBuffer buffer = settings.CreateBuffer();
            var pose = new BoneTransform[BoneHierarchy.BoneCount];
            int next = 0;
            double end = _frames.Count > 0 ? _frames[_frames.Count - 1].Time : double.NegativeInfinity;
            for (double time = _frames.Count > 0 ? _frames[0].Time : 0; time <= end; time += 1 / ShownRate)
            {
                for (; next < _frames.Count && _frames[next].Time <= time; next++)
                    buffer.Push(_frames[next].Pose, _frames[next].Time);

                if (buffer.Sample(settings.Resamples ? time : time + MotionHistory.Length, pose) != PoseOrigin.None)
                    Add(points, time, pose);
            }

            late = settings.Resamples ? buffer.Late : 0;
            return points;
        }

        // As a figure shows it with smoothing.
        public List<Vector2> Smoothed(PartSmoothing smoothing)
        {
            var points = new List<Vector2>(_frames.Count);
            var smoother = new PoseSmoother();
            var pose = new BoneTransform[BoneHierarchy.BoneCount];
            smoothing.CopyTo(smoother, SkeletonVariant.Neck1);
            foreach ((double time, BoneTransform[] received) in _frames)
            {
                received.CopyTo(pose, 0);
                smoother.Smooth(pose, time);
                Add(points, time, pose);
            }

            return points;
        }

        private void Add(List<Vector2> points, double time, BoneTransform[] pose)
        {
            if (time >= Start)
                points.Add(new Vector2((float)(time - Start), Vector3.Dot(TurnOf(pose), _axis) * Mathf.Rad2Deg));
        }

        private Vector3 FindAxis()
        {
            (Vector3 least, Vector3 most) = (Vector3.Zero, Vector3.Zero);
            foreach ((_, BoneTransform[] pose) in _frames)
            {
                Vector3 turn = TurnOf(pose);
                (least, most) = (Vector3.Min(least, turn), Vector3.Max(most, turn));
            }

            Vector3 range = most - least;
            return range.X >= range.Y && range.X >= range.Z ? Vector3.UnitX : range.Y >= range.Z ? Vector3.UnitY : Vector3.UnitZ;
        }

        // Axis times angle, from the first pose, in radians.
        private Vector3 TurnOf(BoneTransform[] pose)
        {
            System.Numerics.Quaternion turn = pose[_bone].Rotation * System.Numerics.Quaternion.Conjugate(_first);
            if (turn.W < 0)
                turn = System.Numerics.Quaternion.Negate(turn);

            var vector = new Vector3(turn.X, turn.Y, turn.Z);
            float sine = vector.Length();
            return sine > 1e-6f ? vector * (2 * MathF.Atan2(sine, turn.W) / sine) : vector * 2;
        }
    }
}
