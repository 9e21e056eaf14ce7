#nullable enable
using System;
using System.Collections.Generic;
using UnityEditor;
using UnityEngine;

namespace NeuronMocap.Unity.EditorTools
{
    /// <summary>Creates an <see cref="AnimationClip"/> from a take of a <see cref="ClipRecorder"/>.</summary>
    public static class ClipWriter
    {
        // A quaternion's components change by up to half the angle, in radians.
        private const float QuaternionPerDegree = Mathf.Deg2Rad / 2;

        // Muscles range from -1 to 1.
        private const float MusclePerPercent = 0.02f;
        private const float MetresPerCentimetre = 0.01f;

        /// <summary>Creates a clip in memory.</summary>
        /// <param name="take">The take, with at least one frame.</param>
        /// <param name="keyTolerance">
        /// The error allowed when keys are removed: percent of a muscle's range, degrees or centimetres. 0 keeps all keys.
        /// </param>
        /// <param name="progress">Receives progress, 0 to 1; may be null.</param>
        /// <returns>The clip. The caller owns it.</returns>
        public static AnimationClip Create(ClipTake take, float keyTolerance, Action<float>? progress = null)
        {
            var clip = new AnimationClip { frameRate = take.FrameRate };
            var bindings = new EditorCurveBinding[take.ValueCount];
            var curves = new AnimationCurve[take.ValueCount];
            int first = 0;
            foreach (ClipProperty property in take.Properties)
            {
                progress?.Invoke(first / (float)take.ValueCount);
                IReadOnlyList<int> kept = Reduce(take, property, first, keyTolerance);
                for (int i = 0; i < property.Components.Count; i++)
                {
                    bindings[first + i] = EditorCurveBinding.FloatCurve(
                        property.Path,
                        property.IsTransform ? typeof(Transform) : typeof(Animator),
                        property.Name + property.Components[i]);
                    curves[first + i] = new AnimationCurve(CreateKeys(take, first + i, kept));
                }

                first += property.Components.Count;
            }

            progress?.Invoke(1);

            // All at once, because each call compiles the whole clip.
            AnimationUtility.SetEditorCurves(clip, bindings, curves);
            if (take.IsHumanoid)
                KeepPlace(clip);

            return clip;
        }

        private static IReadOnlyList<int> Reduce(ClipTake take, ClipProperty property, int first, float tolerance)
        {
            float unit = property.IsRotation ? QuaternionPerDegree
                : property.Components.Count == 3 ? MetresPerCentimetre
                : MusclePerPercent;
            return KeyReduction.Keep(
                take.FrameCount,
                property.Components.Count,
                take.GetTime,
                (frame, value) => take.GetValue(frame, first + value),
                tolerance * unit);
        }

        // Linear from key to key. The take is dense, and curves that overshoot would make feet slide.
        private static Keyframe[] CreateKeys(ClipTake take, int value, IReadOnlyList<int> kept)
        {
            var keys = new Keyframe[kept.Count];
            float inSlope = 0;
            for (int i = 0; i < keys.Length; i++)
            {
                float time = take.GetTime(kept[i]);
                float number = take.GetValue(kept[i], value);
                float outSlope = 0;
                if (i + 1 < keys.Length)
                {
                    float duration = take.GetTime(kept[i + 1]) - time;
                    outSlope = duration > 0 ? (take.GetValue(kept[i + 1], value) - number) / duration : 0;
                }

                keys[i] = new Keyframe(time, number, i == 0 ? outSlope : inSlope, i + 1 < keys.Length ? outSlope : inSlope);
                inSlope = outSlope;
            }

            return keys;
        }

        // Without this, Unity moves the character so that it starts at the origin, facing forward.
        private static void KeepPlace(AnimationClip clip)
        {
            AnimationClipSettings settings = AnimationUtility.GetAnimationClipSettings(clip);
            settings.keepOriginalOrientation = true;
            settings.keepOriginalPositionXZ = true;
            settings.keepOriginalPositionY = true;
            AnimationUtility.SetAnimationClipSettings(clip, settings);
        }
    }
}
