using NeuronMocap.Tool.View.Performers;

namespace NeuronMocap.Tool.View.Control;

/// <summary>Somebody performs, or has another name or body.</summary>
internal sealed record PerformerMessage(string Key, string Name, int Index, string Colour, string Variant, IReadOnlyList<BoneJson> Bones)
    : PerformerJson(Key, Name, Index, Colour, Variant, Bones)
{
    public PerformerMessage(PerformerJson performer)
        : this(performer.Key, performer.Name, performer.Index, performer.Colour, performer.Variant, performer.Bones)
    {
    }

    public string Type { get; } = "performer";
}

/// <summary>A performer has left.</summary>
internal sealed record GoneMessage(string Key)
{
    public string Type { get; } = "gone";
}

/// <summary>A take was opened: by a page, or because a recording has ended.</summary>
internal sealed record TakeMessage(string Id)
{
    public string Type { get; } = "take";
}

/// <summary>Something that the user must know.</summary>
internal sealed record ProblemMessage(string Text)
{
    public string Type { get; } = "problem";
}
