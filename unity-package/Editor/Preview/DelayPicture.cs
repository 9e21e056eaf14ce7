#nullable enable

using System;
using System.Collections.Generic;
using System.Globalization;
using NeuronMocap.Retargeting;
using UnityEditor;
using UnityEngine;

namespace NeuronMocap.Unity.EditorTools
{
    // What a setting of the timing does to the motion, and which delay it costs. It shows the motion that arrives, or else the built-in example.
    internal sealed class DelayPicture : IDisposable
    {
        public const string BufferLabel = "Jitter Buffer";
        public const string SmoothingLabel = "Smoothing Preview";
        public const string PartLabel = "Shown Part";

        // The parts of a group share their settings.
        private static readonly (string Name, BodyParts Part, Bone Bone)[] Parts =
        {
            ("Body", BodyParts.Spine, Bone.Spine),
            ("Arms", BodyParts.RightArm, Bone.RightArm),
            ("Fingers", BodyParts.RightFingers, Bone.RightHandIndex1),
            ("Legs", BodyParts.RightLeg, Bone.RightUpLeg),
        };

        private static readonly GUIContent[] PartNames = Array.ConvertAll(Parts, part => new GUIContent(part.Name));

        private static MotionHistory? _example;

        private readonly HistoryWatch _watch;
        private bool _isOpen;
        private int _part = 1;
        private IReadOnlyList<Vector2> _received = Array.Empty<Vector2>();
        private IReadOnlyList<Vector2> _shown = Array.Empty<Vector2>();
        private long _late;

        public DelayPicture(Func<Performer?> find, bool isOpen)
        {
            _watch = new HistoryWatch(find);
            _isOpen = isOpen;
        }

        private bool IsLive => _watch.Performer != null && _watch.History.Duration >= 2 * MotionCurves.Warmup;

        private MotionHistory History => IsLive ? _watch.History : _example ??= MotionHistory.CreateExample();

        public void Dispose() => _watch.Dispose();

        public void DrawBuffer(MocapSource source)
        {
            if (!Open(BufferLabel))
                return;

            var settings = new SamplingSettings(source.Resample, source.Delay, source.Interpolation);
            if (Event.current.type == EventType.Layout)
            {
                var curves = new MotionCurves(History, Parts[1].Bone);
                (_received, _shown) = (curves.Received(), curves.Resampled(settings, out _late));
            }

            CurvePicture.Draw(_received, _shown);
            Caption(settings.Resamples
                ? string.Format(CultureInfo.InvariantCulture, "Orange: what figures show, {0:0} ms after the frames in grey. {1:#,0} of {2:#,0} frames came too late.", source.Delay, _late, History.Frames.Count)
                : "Orange: what figures show without Resample, each frame as it arrives. No delay is added.");
        }

        public void DrawSmoothing(FigureDriver driver)
        {
            if (!Open(SmoothingLabel))
                return;

            _part = EditorGUILayout.Popup(new GUIContent(PartLabel, "The body part whose motion the picture shows."), _part, PartNames);
            if (Event.current.type == EventType.Layout)
            {
                var curves = new MotionCurves(History, Parts[_part].Bone);
                (_received, _shown) = (curves.Received(), curves.Smoothed(driver.PartSmoothing));
            }

            CurvePicture.Draw(_received, _shown);
            double delay = driver.PartSmoothing.Get(Parts[_part].Part).ToSettings().GetDelay();
            Caption(string.Format(CultureInfo.InvariantCulture, "Orange: what the figure shows, up to {0:0} ms after the motion in grey.", delay));
        }

        private bool Open(string label)
        {
            _isOpen = EditorGUILayout.Foldout(_isOpen, label, toggleOnLabelClick: true);
            _watch.IsOn = _isOpen;
            return _isOpen;
        }

        private void Caption(string text) =>
            EditorGUILayout.LabelField(IsLive ? $"{_watch.Performer}. {text}" : $"Example motion. {text}", EditorStyles.wordWrappedMiniLabel);
    }
}
