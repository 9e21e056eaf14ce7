#nullable enable

using System;
using NeuronMocap.Retargeting;
using NeuronMocap.Skeleton;
using UnityEngine;

namespace NeuronMocap.Unity
{
    // A figure's transforms, and the retargeting of a performer's poses to them.
    internal sealed class FigureRig
    {
        private readonly Retargeter _retargeter;
        private readonly FootPlanter _planter;
        private bool _isPlanting;

        public FigureRig(TargetRig target, Transform[] nodes, string note)
        {
            Target = target;
            Root = nodes[0].parent;
            Note = note;
            Pose = new RetargetedPose(target);
            Mix = new PoseMix(target);
            Nodes = nodes;
            Writer = new PoseWriter(nodes, target);
            Bodies = new BodyWriter(nodes, target, Writer);
            _planter = new FootPlanter(target);
            _retargeter = new Retargeter(target, SkeletonBody.GetDefault(), new RetargetOptions());
        }

        public TargetRig Target { get; }

        // The transform in whose space poses are. Nodes are parents first, so the first one is directly below it.
        public Transform? Root { get; }

        public float Scale => _retargeter.Scale;

        public string Note { get; }

        public RetargetedPose Pose { get; }

        public PoseMix Mix { get; }

        public Transform[] Nodes { get; }

        public PoseWriter Writer { get; }

        public BodyWriter Bodies { get; }

        public RetargetOptions Options => _retargeter.Options;

        public void SetBody(SkeletonBody body) => _retargeter.SetBody(body);

        public bool TryRetarget(ReadOnlySpan<BoneTransform> pose) => _retargeter.TryRetarget(pose, Pose);

        public FootPlanterOptions FootOptions => _planter.Options;

        public void PlantFeet(FootContacts contacts, double seconds)
        {
            _planter.Plant(Pose, contacts, seconds);
            _isPlanting = true;
        }

        public void ForgetFeet()
        {
            if (_isPlanting)
                _planter.Reset();

            _isPlanting = false;
        }
    }
}
