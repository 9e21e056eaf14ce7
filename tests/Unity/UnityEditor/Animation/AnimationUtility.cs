using UnityEngine;

namespace UnityEditor;

public static class AnimationUtility
{
    private static readonly System.Runtime.CompilerServices.ConditionalWeakTable<AnimationClip, AnimationClipSettings> Settings = [];

    public static void SetEditorCurve(AnimationClip clip, EditorCurveBinding binding, AnimationCurve? curve) =>
        clip.Set(binding.path, binding.type, binding.propertyName, curve);

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
