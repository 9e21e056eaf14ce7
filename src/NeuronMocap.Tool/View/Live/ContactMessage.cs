namespace NeuronMocap.Tool.View.Live;

/// <summary>The feet of a performer that stand on the ground.</summary>
internal sealed record ContactMessage(string Key, bool Left, bool Right)
{
    public string Type { get; } = "contact";

    public static ContactMessage Of(LivePerformer performer) =>
        new(performer.Description.Key.ToString(), performer.Contacts.Left, performer.Contacts.Right);
}
