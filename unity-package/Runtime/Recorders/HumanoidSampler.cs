#nullable enable
using System;
using System.Collections.Generic;
using UnityEngine;
using Quaternion = UnityEngine.Quaternion;
using Vector3 = UnityEngine.Vector3;

namespace NeuronMocap.Unity
{
    // Samples a humanoid's pose as body position and rotation, 95 muscles, and the goals of feet and hands. Every other humanoid can play them.
    internal sealed class HumanoidSampler : ClipSampler
    {
        private static readonly string[] Fingers = { "Thumb", "Index", "Middle", "Ring", "Little" };

        private readonly Transform _root;
        private readonly float _scale;
        private readonly HumanPoseHandler _handler;
        private readonly bool _isInWorld;
        private readonly HumanoidGoals? _goals;
        private HumanPose _pose;

        public HumanoidSampler(Animator animator)
            : this(animator, HumanoidGoals.Create(animator))
        {
        }

        private HumanoidSampler(Animator animator, HumanoidGoals? goals)
            : base(CreateProperties(hasGoals: goals is { }))
        {
            _goals = goals;
            _root = animator.transform;
            Origin = new TakeOrigin(_root);
            _scale = animator.humanScale > 0 ? animator.humanScale : 1;
            _handler = new HumanPoseHandler(animator.avatar!, _root);
            _isInWorld = IsBodyInWorld();
        }

        // The names of muscles in clips. They are those of HumanTrait, except for the fingers.
        public static string GetPropertyName(string muscle)
        {
            foreach (string finger in Fingers)
            {
                int place = muscle.IndexOf(" " + finger + " ", StringComparison.Ordinal);
                if (place < 0)
                    continue;

                string side = muscle.Substring(0, place);
                string motion = muscle.Substring(place + finger.Length + 2);
                return $"{side}Hand.{finger}.{motion}";
            }

            return muscle;
        }

        public override bool IsGone => _root == null;

        protected override TakeOrigin Origin { get; }

        public override void Dispose() => _handler.Dispose();

        protected override void Read()
        {
            _handler.GetHumanPose(ref _pose);
            Vector3 position = _pose.bodyPosition;
            Quaternion rotation = _pose.bodyRotation;
            if (_isInWorld)
            {
                position = _root.InverseTransformPoint(position * _scale) / _scale;
                rotation = Quaternion.Inverse(_root.rotation) * rotation;
            }

            Origin.Follow();
            Put(Origin.ToStart(position * _scale) / _scale);
            Put(Origin.ToStart(rotation));
            foreach (float muscle in _pose.muscles)
                Put(muscle);

            if (_goals is null)
                return;

            _goals.Read(_pose, position * _scale, rotation);
            for (int i = 0; i < HumanoidGoals.Names.Length; i++)
            {
                Put(_goals.Positions[i]);
                Put(_goals.Rotations[i]);
            }
        }

        private static IReadOnlyList<ClipProperty> CreateProperties(bool hasGoals)
        {
            var properties = new List<ClipProperty> { ClipProperty.BodyPosition("Root"), ClipProperty.BodyRotation("Root") };
            foreach (string muscle in HumanTrait.MuscleName)
                properties.Add(ClipProperty.Muscle(GetPropertyName(muscle)));

            for (int i = 0; hasGoals && i < HumanoidGoals.Names.Length; i++)
            {
                properties.Add(ClipProperty.BodyPosition(HumanoidGoals.Names[i]));
                properties.Add(ClipProperty.BodyRotation(HumanoidGoals.Names[i]));
            }

            return properties;
        }

        // Unity's reference does not say whether the body is relative to the root or to the world. Moving the root for a moment shows it.
        private bool IsBodyInWorld()
        {
            _handler.GetHumanPose(ref _pose);
            Vector3 before = _pose.bodyPosition;
            Vector3 place = _root.position;
            _root.position = place + Vector3.right;
            _handler.GetHumanPose(ref _pose);
            _root.position = place;
            return (_pose.bodyPosition - before).magnitude > 0.5f / _scale;
        }
    }
}
