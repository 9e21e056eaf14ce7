using UnityEngine;

namespace UnityEditor;

public static class AnimationUtility
{
    private static readonly System.Runtime.CompilerServices.ConditionalWeakTable<AnimationClip, AnimationClipSettings> Settings = [];

    /// <summary>For tests: how often a clip was compiled anew, which takes long for many curves. Each call that sets curves does it once.</summary>
    public static int Syncs { get; set; }

    public static void SetEditorCurve(AnimationClip clip, EditorCurveBinding binding, AnimationCurve? curve) => SetEditorCurves(clip, [binding], [curve]);

    public static void SetEditorCurves(AnimationClip clip, EditorCurveBinding[] bindings, AnimationCurve?[] curves)
    {
        if (bindings.Length != curves.Length)
            throw new ArgumentException("There must be one curve for each binding.", nameof(curves));

        for (int i = 0; i < bindings.Length; i++)
            clip.Set(bindings[i].path, bindings[i].type, bindings[i].propertyName, curves[i]);

        Syncs++;
    }

    public static AnimationCurve? GetEditorCurve(AnimationClip clip, EditorCurveBinding binding) =>
        clip.Curves.TryGetValue((binding.path, binding.type, binding.propertyName), out AnimationCurve? curve) ? curve : null;

    public static EditorCurveBinding[] GetCurveBindings(AnimationClip clip) =>
        [.. clip.Curves.Keys.Select(static key => EditorCurveBinding.FloatCurve(key.Path, key.Type, key.Property))];

    public static AnimationClipSettings GetAnimationClipSettings(AnimationClip clip) =>
        Settings.TryGetValue(clip, out AnimationClipSettings? settings) ? settings : new AnimationClipSettings();

    public static void SetAnimationClipSettings(AnimationClip clip, AnimationClipSettings srcClipInfo)
    {
        Settings.Remove(clip);
        Settings.Add(clip, srcClipInfo);
    }
}
