using System.Numerics;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tool.View.Performers;

/// <summary>Somebody whose motion the page shows. Immutable.</summary>
/// <param name="Key">The identity.</param>
/// <param name="Name">The name in the stream or in the file.</param>
/// <param name="Index">The avatar number in the compact poses that the page gets. No other performer has it.</param>
/// <param name="Body">The sizes of the body, in centimetres.</param>
internal sealed record Performer(PerformerKey Key, string Name, int Index, SkeletonBody Body)
{
    // Distinct for people with colour-vision deficiencies, and visible on light and dark ground.
    private static readonly string[] Colours = ["#4f8fdc", "#e08a3c", "#3fa98f", "#b678d6", "#d65c6f", "#9aa33d", "#5fb4d8", "#a9836b"];

    private const float MetresPerCentimetre = 0.01f;

    /// <summary>The colour as #rrggbb. It follows from the number, so that it is the same in every browser.</summary>
    public string Colour => Colours[(int)((uint)Index % (uint)Colours.Length)];

    /// <summary>Describes the performer for the page, in metres.</summary>
    public PerformerJson ToJson() => new(
        Key.ToString(),
        Name,
        Index,
        Colour,
        Body.Variant.ToString(),
        [.. BoneHierarchy.Bones.ToArray().Select(bone => new BoneJson(NameOf(bone), ParentOf(bone), ToMetres(Body.GetOffset(bone))))]);

    private string NameOf(Bone bone) => BoneHierarchy.GetName(bone, Body.Variant);

    private string? ParentOf(Bone bone) => BoneHierarchy.GetParent(bone, Body.Variant) is { } parent ? NameOf(parent) : null;

    private static float[] ToMetres(Vector3 offset) => [ToMetres(offset.X), ToMetres(offset.Y), ToMetres(offset.Z)];

    // A server can report any number, but JSON has only finite ones.
    private static float ToMetres(float centimetres) => float.IsFinite(centimetres) ? centimetres * MetresPerCentimetre : 0;
}

/// <summary>A performer as the page gets it.</summary>
/// <param name="Key">The identity, "SENDER-AVATAR".</param>
/// <param name="Name">The name.</param>
/// <param name="Index">The avatar number in compact poses.</param>
/// <param name="Colour">#rrggbb.</param>
/// <param name="Variant">"Neck1" or "Spine3".</param>
/// <param name="Bones">The 59 bones, parents first, in the order of the rotations of a compact pose.</param>
internal record PerformerJson(string Key, string Name, int Index, string Colour, string Variant, IReadOnlyList<BoneJson> Bones);

/// <summary>A bone as the page gets it.</summary>
/// <param name="Name">The name in the stream.</param>
/// <param name="Parent">The name of the parent; null for the hips.</param>
/// <param name="Offset">The position relative to the parent at rest: x, y and z in metres.</param>
internal sealed record BoneJson(string Name, string? Parent, float[] Offset);
