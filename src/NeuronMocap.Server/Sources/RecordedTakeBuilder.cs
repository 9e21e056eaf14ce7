using NeuronMocap.Skeleton;

namespace NeuronMocap.Server.Sources;

/// <summary>Collects the frames of one avatar of one sender in the order in which the server numbered them.</summary>
internal sealed class RecordedTakeBuilder
{
    // The same limit as in a reader. After a larger step back, the server has restarted its numbers.
    private const int LargestDisorder = 63;

    private readonly SortedDictionary<(int Avatar, int Sender), string> _others = [];
    private uint? _contactsIndex;
    private FootContacts _contacts;

    public RecordedTakeBuilder(int? avatarIndex, int? sender) => (AvatarIndex, Sender) = (avatarIndex, sender);

    public List<RecordedTakeRow> Rows { get; } = [];

    public int? AvatarIndex { get; private set; }

    public int? Sender { get; private set; }

    public string AvatarName { get; private set; } = "";

    public ChannelLayout Layout { get; private set; }

    public SkeletonFormat Format { get; private set; }

    /// <summary>Other avatars with poses in the recording.</summary>
    public IReadOnlyDictionary<(int Avatar, int Sender), string> Others => _others;

    public bool HasContacts { get; private set; }

    public void Add(AvatarFrame frame, TimeSpan time, int connection)
    {
        switch (frame)
        {
            case MotionFrame { HasSkeleton: true } motion:
                AddMotion(motion, time, connection);
                break;
            case CalculationFrame { BoneCount: > 0 } calculation when IsWanted(calculation):
                AddContacts(calculation);
                break;
            default:
                break;
        }
    }

    private bool IsWanted(AvatarFrame frame) => frame.AvatarIndex == (AvatarIndex ?? frame.AvatarIndex) && frame.Sender == (Sender ?? frame.Sender);

    private void AddMotion(MotionFrame frame, TimeSpan time, int connection)
    {
        if (!IsWanted(frame))
        {
            _others[(frame.AvatarIndex, frame.Sender)] = frame.AvatarName;
            return;
        }

        (AvatarIndex, Sender) = (frame.AvatarIndex, frame.Sender);
        if (Rows.Count == 0)
            (AvatarName, Layout, Format) = (frame.AvatarName, frame.Layout, frame.Format);

        int place = FindPlace(frame.FrameIndex, connection);
        if (place < 0)
            return;

        float[] values = frame.Layout == Layout && frame.Format.RotationOrder == Format.RotationOrder ? frame.Values.ToArray() : Rewrite(frame);
        var row = new RecordedTakeRow(values, frame.FrameIndex, time, connection);
        if (_contactsIndex == frame.FrameIndex)
            row.Contacts = _contacts;

        Rows.Insert(place, row);
    }

    // The contacts belong to the motion packet with the same frame index. Either packet may come first.
    private void AddContacts(CalculationFrame frame)
    {
        HasContacts = true;
        (_contactsIndex, _contacts) = (frame.FrameIndex, frame.FootContacts);
        if (Rows.Count > 0 && Rows[^1].Index == frame.FrameIndex)
            Rows[^1].Contacts = _contacts;
    }

    // Datagrams can overtake each other. Returns -1 for a frame that arrived twice.
    private int FindPlace(uint? index, int connection)
    {
        int place = Rows.Count;
        while (index is { } number && place > 0 && Rows[place - 1] is { Index: { } before } row && row.Connection == connection)
        {
            int step = (int)(number - before);
            if (step == 0)
                return -1;
            if (step is > 0 or < -LargestDisorder)
                return step > 0 ? place : Rows.Count;

            place--;
        }

        return place;
    }

    // The settings of the server changed in the middle of the recording.
    private float[] Rewrite(MotionFrame frame)
    {
        float[] values = new float[Layout.ValueCount];
        foreach (Bone bone in BoneHierarchy.Bones)
        {
            BoneTransform transform = frame[bone];
            if (bone == Bone.Hips && !Layout.HasReference)
                transform = frame.GetReference().Apply(transform);

            PoseValues.Write(values, Layout, Format.RotationOrder, bone, transform);
        }

        if (Layout.HasReference)
            PoseValues.WriteReference(values, Format.RotationOrder, frame.GetReference());

        return values;
    }
}
