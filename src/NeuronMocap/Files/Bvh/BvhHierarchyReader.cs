using System.Globalization;
using System.Numerics;
using System.Text;
using NeuronMocap.Protocol;
using static NeuronMocap.Bvh.BvhWord;

namespace NeuronMocap.Bvh;

// Reads from HIERARCHY up to MOTION or the end. It reads word by word and without recursion; deep nesting therefore cannot exhaust the stack.
internal ref struct BvhHierarchyReader
{
    private readonly BvhRepairLog _repairs;
    private readonly BvhTextFormatBuilder _format;
    private readonly List<BvhJoint> _joints = [];
    private BvhText _text;
    private BvhJoint? _open;
    private bool _inEndSite;
    private int _depth;
    private int _channelCount;
    private BvhTextPosition _place;
    private byte _blank;
    private bool _isFirstOnLine;

    private BvhHierarchyReader(BvhText text, BvhRepairLog repairs, BvhTextFormatBuilder format)
    {
        _text = text;
        _repairs = repairs;
        _format = format;
    }

    /// <summary>Reads the joints. The remaining text is empty or begins with MOTION.</summary>
    public static BvhHierarchy Read(ref BvhText text, BvhRepairLog repairs, BvhTextFormatBuilder format)
    {
        var reader = new BvhHierarchyReader(text, repairs, format);
        reader.Read();
        text = reader._text;
        return new BvhHierarchy(reader._joints, reader._channelCount);
    }

    private void Read()
    {
        _format.HasByteOrderMark = _text.TrySkipByteOrderMark();
        FindHierarchy();
        while (!IsMotion(_text.PeekWord()))
            ReadStatement();

        _place = _text.Place;
        if (_joints.Count == 0)
            throw Refuse("The hierarchy has no joints.");
        if (_open is not null)
            _repairs.Add(_place, $"The hierarchy ends inside {Describe(_open)}", $"open blocks are closed here");

        while (_open is not null)
            CloseJoint();
    }

    // The end of the text also counts. If the word MOTION is missing, the "Frame" lines that usually follow it are the next best sign.
    private static bool IsMotion(ReadOnlySpan<byte> word) =>
        word.IsEmpty || AreEqual(word, "MOTION"u8) || StartsWith(word, "Frame"u8);

    private static string Describe(BvhJoint joint) =>
        joint.Name.Length == 0 ? "a joint without a name" : $"joint {Quote(joint.Name)}";

    private void FindHierarchy()
    {
        ReadOnlySpan<byte> first = _text.PeekWord();
        _place = _text.Place;
        if (first.IsEmpty)
            throw Refuse("The file is empty.");
        if (_text.TryReadWord("HIERARCHY"u8))
            return;

        string quote = Quote(first);
        while (!_text.TryReadWord("HIERARCHY"u8))
        {
            if (_text.ReadWord().IsEmpty)
                throw new BvhFormatException($"The file has no HIERARCHY; it begins with {quote}.", _place.Line, _place.Column);
        }

        _repairs.Add(_place, $"The file begins with {quote}", $"the text before HIERARCHY is ignored");
    }

    private void ReadStatement()
    {
        ReadOnlySpan<byte> word = _text.PeekWord();
        _place = _text.Place;
        _blank = _text.LastBlank;
        _isFirstOnLine = _text.IsFirstOnLine;
        bool isRoot = AreEqual(word, "ROOT"u8);
        if (isRoot || AreEqual(word, "JOINT"u8))
            OpenJoint(isRoot);
        else if (word[0] == '}')
            Close();
        else if (_open is not null && AreEqual(word, "End"u8))
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
            ReportKind(isRoot);

        _open = new BvhJoint(ReadName(), _joints.Count, _open) { FirstChannel = _channelCount };
        _joints.Add(_open);
        _depth++;
        if (_open.Name.Length == 0)
            _repairs.Add(_place, $"Joint number {_joints.Count} has no name", $"it gets an empty name");

        ReadOpeningBrace();
    }

    private readonly void ReportKind(bool isRoot)
    {
        if (isRoot)
            _repairs.Add(_place, $"A ROOT is inside {Describe(_open!)}", $"it is read as a JOINT");
        else
            _repairs.Add(_place, $"A JOINT is outside any other joint", $"it is read as a ROOT");
    }

    // Names may contain spaces, and may stand on the next line.
    private string ReadName()
    {
        string name = ReadRest();
        return name.Length > 0 || IsStatement(_text.PeekWord()) ? name : ReadRest();
    }

    private string ReadRest() => _text.TryReadToBrace(out ReadOnlySpan<byte> rest)
        ? Encoding.UTF8.GetString(rest)
        : throw Refuse($"A name is longer than {BvhText.LongestWord} bytes.");

    private void OpenEndSite()
    {
        _text.SkipToBrace();
        LeaveEndSite();
        if (_open!.EndSite is not null)
            _repairs.Add(_place, $"Another End Site of {Describe(_open)}", $"it replaces the previous one");

        _inEndSite = true;
        _open.EndSite = Vector3.Zero;
        ReadOpeningBrace();
    }

    private void LeaveEndSite()
    {
        if (_inEndSite)
            _repairs.Add(_place, $"The End Site of {Describe(_open!)} is not closed", $"it is closed here");

        _inEndSite = false;
    }

    private void ReadOpeningBrace()
    {
        if (!_text.TryReadWord("{"u8))
            _repairs.Add(_place, $"There is no {{ after {(_inEndSite ? "End Site" : Describe(_open!))}", $"it is added");
    }

    private void Close()
    {
        _text.ReadWord();
        if (_inEndSite)
            _inEndSite = false;
        else if (_open is not null)
            CloseJoint();
        else
            _repairs.Add(_place, $"There is a }} that closes nothing", $"it is ignored");
    }

    private void CloseJoint()
    {
        if (!_open!.HasOffset)
            _repairs.Add(_place, $"There is no OFFSET in {Describe(_open)}", $"zero is assumed");

        _inEndSite = false;
        _open = _open.Parent;
        _depth--;
    }

    private void ReadOffset()
    {
        if (_format.Indentation is null && _depth == 1 && _isFirstOnLine && _place.Column - 1 <= BvhTextFormat.LongestBlanks)
            _format.Indentation = new string((char)_blank, _place.Column - 1);

        var offset = new Vector3(ReadCoordinate(), ReadCoordinate(), ReadCoordinate());
        if (_inEndSite)
        {
            _open!.EndSite = offset;
            return;
        }

        if (_open!.HasOffset)
            _repairs.Add(_place, $"Another OFFSET of {Describe(_open)}", $"it replaces the previous one");

        _open.Offset = offset;
        _open.HasOffset = true;
    }

    private float ReadCoordinate()
    {
        ReadOnlySpan<byte> word = _text.PeekWord();
        if (!TextNumber.TryParse(word, out float value))
        {
            BvhTextPosition place = _text.Place.Line == _place.Line ? _text.Place : _place;
            _repairs.Add(place, $"The OFFSET in {Describe(_open!)} lacks a number", $"zero is assumed");
            return 0;
        }

        if (!float.IsFinite(value))
            _repairs.Add(_text.Place, $"The OFFSET in {Describe(_open!)} holds {word}", $"it is kept");

        _format.AddOffset(word);
        _text.Advance(word.Length);
        return value;
    }

    // Each name is one column. The number only tells how many of the unknown words are also names.
    private void ReadChannels()
    {
        ReadOnlySpan<byte> word = _text.PeekWord();
        bool hasCount = TextNumber.TryParse(word, out float count);
        if (hasCount)
            _text.Advance(word.Length);

        bool isFirst = _open!.Channels.Count == 0 && !_inEndSite;
        if (!isFirst && !IsStatement(_text.PeekWord()))
        {
            string owner = _inEndSite ? "End Site" : "second CHANNELS";
            throw Refuse($"The {owner} of {Describe(_open)} has channels; their values cannot be assigned to a joint.");
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

        string announced = hasCount ? Quote(count.ToString(CultureInfo.InvariantCulture)) : "no number";
        _repairs.Add(_place, $"CHANNELS of {Describe(_open)} declares {announced} but names {read}", $"the names are used");
    }

    private bool TryReadChannel(bool isKnownOnly, out BvhChannel channel)
    {
        ReadOnlySpan<byte> word = _text.PeekWord();
        channel = ChannelOf(word);
        if (channel == BvhChannel.Unknown && (isKnownOnly || IsStatement(word)))
            return false;
        if (_channelCount + _open!.Channels.Count == BvhDocument.MaxChannels)
            throw Refuse($"There are more than {BvhDocument.MaxChannels} channels.");
        if (channel == BvhChannel.Unknown)
            _repairs.Add(_text.Place, $"The channel {word} of {Describe(_open)} is unknown", $"it keeps its place in the row");

        _text.Advance(word.Length);
        return true;
    }

    private static BvhChannel ChannelOf(ReadOnlySpan<byte> word)
    {
        bool isPosition = word.Length == 9 && AreEqual(word[1..], "position"u8);
        bool isRotation = word.Length == 9 && AreEqual(word[1..], "rotation"u8);
        int axis = isPosition || isRotation ? (word[0] | 0x20) - 'x' : -1;
        if (axis is < 0 or > 2)
            return BvhChannel.Unknown;

        return (isPosition ? BvhChannel.Xposition : BvhChannel.Xrotation) + axis;
    }

    private static bool IsStatement(ReadOnlySpan<byte> word) =>
        word.IsEmpty
        || word[0] is (byte)'{' or (byte)'}'
        || IsMotion(word)
        || AreEqual(word, "JOINT"u8)
        || AreEqual(word, "ROOT"u8)
        || AreEqual(word, "End"u8)
        || AreEqual(word, "OFFSET"u8)
        || AreEqual(word, "CHANNELS"u8);

    private void SkipUnknown()
    {
        ReadOnlySpan<byte> word = _text.PeekWord();
        bool isBrace = word[0] == '{';
        _repairs.Add(_place, $"{word} is not expected here", $"it is ignored with the rest of its line");
        _text.Advance(word.Length);
        if (!isBrace)
            _text.SkipToBrace();
    }

    private BvhFormatException Refuse(string message)
    {
        _text.SkipSpace();
        return new BvhFormatException(message, _text.Place.Line, _text.Place.Column);
    }
}
