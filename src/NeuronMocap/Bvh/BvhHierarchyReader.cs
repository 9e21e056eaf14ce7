using System.Numerics;
using System.Text;
using NeuronMocap.Protocol;

namespace NeuronMocap.Bvh;

// Reads from HIERARCHY up to MOTION or the end: a word at a time and without recursion, so that no nesting can exhaust the stack.
internal ref struct BvhHierarchyReader
{
    private readonly BvhRepairLog _repairs;
    private readonly List<BvhJoint> _joints = [];
    private BvhText _text;
    private BvhJoint? _open;
    private bool _inEndSite;
    private int _depth;
    private int _channelCount;
    private int _line;

    public BvhHierarchyReader(BvhText text, BvhRepairLog repairs)
    {
        _text = text;
        _repairs = repairs;
    }

    public readonly IReadOnlyList<BvhJoint> Joints => _joints;

    public readonly int ChannelCount => _channelCount;

    /// <summary>Reads the joints.</summary>
    /// <returns>What comes after them: nothing, or text that begins with MOTION.</returns>
    public BvhText Read()
    {
        FindHierarchy();
        while (!IsMotion(_text.PeekWord()))
            ReadStatement();

        _line = _text.Line;
        if (_joints.Count == 0)
            throw Refuse("The hierarchy has no joints.");
        if (_open is not null)
            _repairs.Add(_line, $"The hierarchy ends inside {Describe(_open)}; what is open is closed here.");

        while (_open is not null)
            CloseJoint();

        return _text;
    }

    // The end counts as well. Without the word MOTION, what it would announce is the next best sign of it.
    private static bool IsMotion(ReadOnlySpan<byte> word) =>
        word.IsEmpty || BvhText.AreEqual(word, "MOTION"u8) || BvhText.StartsWith(word, "Frame"u8);

    private static string Describe(BvhJoint joint) =>
        joint.Name.Length == 0 ? "a joint without a name" : $"joint {BvhText.Quote(joint.Name)}";

    private void FindHierarchy()
    {
        BvhText start = _text;
        ReadOnlySpan<byte> first = start.PeekWord();
        if (first.IsEmpty)
            throw new BvhFormatException("The file is empty.", start.Line, start.Column);

        _line = start.Line;
        while (!_text.TryReadWord("HIERARCHY"u8))
        {
            if (_text.ReadWord().IsEmpty)
            {
                string message = $"There is no HIERARCHY; the file begins with {BvhText.Quote(first)}.";
                throw new BvhFormatException(message, start.Line, start.Column);
            }
        }

        if (!BvhText.AreEqual(first, "HIERARCHY"u8))
            _repairs.Add(_line, $"The file begins with {BvhText.Quote(first)}; what comes before HIERARCHY is ignored.");
    }

    private void ReadStatement()
    {
        ReadOnlySpan<byte> word = _text.PeekWord();
        _line = _text.Line;
        bool isRoot = BvhText.AreEqual(word, "ROOT"u8);
        if (isRoot || BvhText.AreEqual(word, "JOINT"u8))
            OpenJoint(isRoot);
        else if (word[0] == '}')
            Close();
        else if (_open is not null && BvhText.AreEqual(word, "End"u8))
            OpenEndSite();
        else if (_open is not null && _text.TryReadWord("OFFSET"u8))
            ReadOffset();
        else if (_open is not null && _text.TryReadWord("CHANNELS"u8))
            ReadChannels();
        else
            SkipUnknown();
    }

    private void OpenJoint(bool isRoot)
    {
        if (_joints.Count == BvhDocument.MaxJoints)
            throw Refuse($"There are more than {BvhDocument.MaxJoints} joints.");
        if (_depth == BvhDocument.MaxDepth)
            throw Refuse($"Joints are nested more than {BvhDocument.MaxDepth} deep.");

        _text.ReadWord();
        LeaveEndSite();
        if (isRoot != (_open is null))
            _repairs.Add(_line, $"{(isRoot ? $"A ROOT inside {Describe(_open!)} is read as a JOINT." : "A JOINT outside of any other is read as a ROOT.")}");

        _open = new BvhJoint(ReadName(), _joints.Count, _open) { FirstChannel = _channelCount };
        _joints.Add(_open);
        _depth++;
        if (_open.Name.Length == 0)
            _repairs.Add(_line, $"Joint number {_joints.Count} has no name.");

        ReadOpeningBrace();
    }

    // Names may hold spaces, and may stand on the line after.
    private string ReadName()
    {
        ReadOnlySpan<byte> name = _text.ReadToBrace();
        ReadOnlySpan<byte> next = _text.PeekWord();
        if (name.IsEmpty && !IsStatement(next))
            name = _text.ReadToBrace();

        return Encoding.UTF8.GetString(name);
    }

    private void OpenEndSite()
    {
        _text.ReadToBrace();
        LeaveEndSite();
        if (_open!.EndSite is not null)
            _repairs.Add(_line, $"A further End Site of {Describe(_open)} takes the place of the one before.");

        _inEndSite = true;
        _open.EndSite = Vector3.Zero;
        ReadOpeningBrace();
    }

    private void LeaveEndSite()
    {
        if (_inEndSite)
            _repairs.Add(_line, $"The End Site of {Describe(_open!)} is not closed; it is closed here.");

        _inEndSite = false;
    }

    private void ReadOpeningBrace()
    {
        if (!_text.TryReadWord("{"u8))
            _repairs.Add(_line, $"There is no {{ after {(_inEndSite ? "End Site" : Describe(_open!))}; it is read as if there were.");
    }

    private void Close()
    {
        _text.ReadWord();
        if (_inEndSite)
            _inEndSite = false;
        else if (_open is not null)
            CloseJoint();
        else
            _repairs.Add(_line, "A } that closes nothing is ignored.");
    }

    private void CloseJoint()
    {
        if (!_open!.HasOffset)
            _repairs.Add(_line, $"There is no OFFSET in {Describe(_open)}; it is taken as zero.");

        _inEndSite = false;
        _open = _open.Parent;
        _depth--;
    }

    private void ReadOffset()
    {
        var offset = new Vector3(ReadCoordinate(), ReadCoordinate(), ReadCoordinate());
        if (_inEndSite)
        {
            _open!.EndSite = offset;
            return;
        }

        if (_open!.HasOffset)
            _repairs.Add(_line, $"A further OFFSET of {Describe(_open)} takes the place of the one before.");

        _open.Offset = offset;
        _open.HasOffset = true;
    }

    private float ReadCoordinate()
    {
        ReadOnlySpan<byte> word = _text.PeekWord();
        if (!TextNumber.TryParse(word, out float value))
        {
            _repairs.Add(_line, $"The OFFSET in {Describe(_open!)} lacks a number; it is taken as zero.");
            return 0;
        }

        _text.ReadWord();
        if (!float.IsFinite(value))
            _repairs.Add(_line, $"The OFFSET in {Describe(_open!)} holds {BvhText.Quote(word)}; it is kept as that.");

        return value;
    }

    // The names decide: each stands for a column. The number only says how many words without a known meaning are names, too.
    private void ReadChannels()
    {
        ReadOnlySpan<byte> word = _text.PeekWord();
        bool hasCount = TextNumber.TryParse(word, out float count);
        if (hasCount)
            _text.ReadWord();

        bool isFirst = _open!.Channels.Count == 0 && !_inEndSite;
        if (!isFirst && !IsStatement(_text.PeekWord()))
        {
            string owner = _inEndSite ? "End Site" : "second CHANNELS";
            throw Refuse($"The {owner} of {Describe(_open)} has channels; whose values they are cannot be known.");
        }

        if (isFirst)
            _open.FirstChannel = _channelCount;

        int read = 0;
        while (TryReadChannel(isKnownOnly: !hasCount || !(read < count), out BvhChannel channel))
        {
            _open.AddChannel(channel);
            read++;
        }

        _channelCount += read;
        if (hasCount && read == count)
            return;

        _repairs.Add(
            _line,
            $"CHANNELS of {Describe(_open)} announces {(hasCount ? BvhText.Quote(word) : "no number")} and names {read}; the names are followed.");
    }

    private bool TryReadChannel(bool isKnownOnly, out BvhChannel channel)
    {
        ReadOnlySpan<byte> word = _text.PeekWord();
        channel = ChannelOf(word);
        if (channel == BvhChannel.Unknown && (isKnownOnly || IsStatement(word)))
            return false;
        if (channel == BvhChannel.Unknown)
            _repairs.Add(_line, $"The channel {BvhText.Quote(word)} of {Describe(_open!)} is unknown; it keeps its place in the row.");

        _text.ReadWord();
        return true;
    }

    private static BvhChannel ChannelOf(ReadOnlySpan<byte> word)
    {
        bool isPosition = word.Length == 9 && BvhText.AreEqual(word[1..], "position"u8);
        bool isRotation = word.Length == 9 && BvhText.AreEqual(word[1..], "rotation"u8);
        int axis = isPosition || isRotation ? (word[0] | 0x20) - 'x' : -1;
        if (axis is < 0 or > 2)
            return BvhChannel.Unknown;

        return (isPosition ? BvhChannel.Xposition : BvhChannel.Xrotation) + axis;
    }

    private static bool IsStatement(ReadOnlySpan<byte> word) =>
        word.IsEmpty
        || word[0] is (byte)'{' or (byte)'}'
        || IsMotion(word)
        || BvhText.AreEqual(word, "JOINT"u8)
        || BvhText.AreEqual(word, "ROOT"u8)
        || BvhText.AreEqual(word, "End"u8)
        || BvhText.AreEqual(word, "OFFSET"u8)
        || BvhText.AreEqual(word, "CHANNELS"u8);

    private void SkipUnknown()
    {
        ReadOnlySpan<byte> word = _text.ReadWord();
        if (word[0] != '{')
            _text.ReadToBrace();

        _repairs.Add(_line, $"{BvhText.Quote(word)} has no place here; it is ignored, and so is the rest of its line.");
    }

    private readonly BvhFormatException Refuse(string message)
    {
        BvhText here = _text;
        here.PeekWord();
        return new BvhFormatException(message, here.Line, here.Column);
    }
}
