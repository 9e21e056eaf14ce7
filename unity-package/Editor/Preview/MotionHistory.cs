#nullable enable

using System;
using System.Collections.Generic;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;
using Quaternion = System.Numerics.Quaternion;
using Vector3 = System.Numerics.Vector3;

namespace NeuronMocap.Unity.EditorTools
{
    // The latest frames of a performer with their arrival times, in seconds. The oldest frame leaves when a new one comes.
    internal sealed class MotionHistory
    {
        public const double Length = 3; // s

        private const double ExampleRate = 60;
        private const double ExampleLateness = 0.02; // s
        private const float ExampleNoise = 0.02f; // rad

        private readonly List<(double Time, BoneTransform[] Pose)> _frames = new List<(double Time, BoneTransform[] Pose)>();

        public IReadOnlyList<(double Time, BoneTransform[] Pose)> Frames => _frames;

        // In seconds.
        public double Duration => _frames.Count > 0 ? _frames[_frames.Count - 1].Time - _frames[0].Time : 0;

        // The walk of the simulator, with noise, over a network that delays each frame by up to 20 ms. It is always the same.
        public static MotionHistory CreateExample()
        {
            var example = new MotionHistory();
            var random = new Random(1);
            var walk = new SyntheticSource(ExampleRate);
            var pose = new BoneTransform[BoneHierarchy.BoneCount];
            for (int frame = 0; frame < Length * ExampleRate; frame++)
            {
                walk.GetPose(frame, pose);
                for (int bone = 0; bone < pose.Length; bone++)
                    pose[bone] = new BoneTransform(pose[bone].Position, pose[bone].Rotation * CreateNoise(random));

                example.Add((frame / ExampleRate) + (random.NextDouble() * ExampleLateness), pose);
            }

            return example;
        }

        // A frame that is not later than the last one is not new. Frames that arrived at the same time are one picture on the screen.
        public void Add(double time, ReadOnlySpan<BoneTransform> pose)
        {
            if (_frames.Count > 0 && time <= _frames[_frames.Count - 1].Time)
                return;

            BoneTransform[] copy = TakeOldest(time - Length) ?? new BoneTransform[BoneHierarchy.BoneCount];
            pose.Slice(0, copy.Length).CopyTo(copy);
            _frames.Add((time, copy));
        }

        public void Clear() => _frames.Clear();

        private BoneTransform[]? TakeOldest(double before)
        {
            if (_frames.Count == 0 || _frames[0].Time >= before)
                return null;

            BoneTransform[] oldest = _frames[0].Pose;
            _frames.RemoveAt(0);
            return oldest;
        }

        private static Quaternion CreateNoise(Random random)
        {
            var axis = new Vector3((float)random.NextDouble() - 0.5f, (float)random.NextDouble() - 0.5f, (float)random.NextDouble() - 0.5f);
            return Quaternion.Normalize(new Quaternion(axis * ExampleNoise, 1));
        }
    }
}
