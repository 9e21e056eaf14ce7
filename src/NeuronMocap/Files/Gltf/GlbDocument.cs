using NeuronMocap.Figures;

namespace NeuronMocap.Gltf;

// The contents of a file: JSON text that describes the numbers, then the numbers.
internal sealed class GlbDocument
{
    private const uint Magic = 0x46546C67; // glTF
    private const uint JsonChunk = 0x4E4F534A; // JSON
    private const uint BinaryChunk = 0x004E4942; // BIN
    private const int ChunkHeader = 8;
    private const int FileHeader = 12;
    private const byte Space = 0x20;
    private const float Roughness = 0.65f;

    private readonly IReadOnlyList<GlbAvatar> _avatars;
    private readonly GlbBinary _binary = new();
    private readonly List<GlbFigure> _figures = [];

    public GlbDocument(IReadOnlyList<GlbAvatar> avatars)
    {
        _avatars = avatars;
        foreach (GlbAvatar avatar in avatars)
            _figures.Add(new GlbFigure(avatar.Name, avatar.Body, _figures.Count * GlbFigure.NodeCount, _binary));
    }

    public void Write(Stream output)
    {
        byte[] json = GetJson();
        long padded = GlbBinary.Padded(json.Length);
        long binary = _binary.Length > 0 ? ChunkHeader + _binary.Length : 0;
        WriteNumbers(output, Magic, 2, checked((uint)(FileHeader + ChunkHeader + padded + binary)), (uint)padded, JsonChunk);
        output.Write(json, 0, json.Length);
        for (long i = json.Length; i < padded; i++)
            output.WriteByte(Space);

        if (binary == 0)
            return;

        WriteNumbers(output, (uint)_binary.Length, BinaryChunk);
        _binary.Write(output);
    }

    private byte[] GetJson()
    {
        GltfJson json = new GltfJson().Object();
        json.Object("asset").Text("version", "2.0").Text("generator", "NeuronMocap").EndObject();
        json.Number("scene", 0).Array("scenes").Object();
        if (_figures.Count > 0)
            DescribeFigures(json);
        else
            json.EndObject().EndArray();

        // Also adds the numbers of the animations.
        DescribeAnimations(json);
        _binary.Describe(json);
        return json.EndObject().ToUtf8();
    }

    private void DescribeFigures(GltfJson json)
    {
        json.Numbers("nodes", _figures.SelectMany(static figure => figure.Roots)).EndObject().EndArray().Array("nodes");
        for (int i = 0; i < _figures.Count; i++)
            _figures[i].DescribeNodes(json, i);

        json.EndArray().Array("materials");
        DescribeMaterial(json, "Figure body", FigureColors.Body);
        foreach (GlbAvatar avatar in _avatars)
            DescribeMaterial(json, $"{avatar.Name} joints", avatar.AccentColor);

        json.EndArray().Array("meshes");
        for (int i = 0; i < _figures.Count; i++)
            _figures[i].DescribeMesh(json, bodyMaterial: 0, accentMaterial: i + 1);

        json.EndArray().Array("skins");
        foreach (GlbFigure figure in _figures)
            figure.DescribeSkin(json);

        json.EndArray();
    }

    private void DescribeAnimations(GltfJson json)
    {
        if (_avatars.All(static avatar => avatar.Animation.Times.Count == 0))
            return;

        json.Array("animations");
        for (int i = 0; i < _avatars.Count; i++)
        {
            if (_avatars[i].Animation.Times.Count > 0)
                new GlbAnimation(_avatars[i], _figures[i], _binary).Describe(json);
        }

        json.EndArray();
    }

    private static void DescribeMaterial(GltfJson json, string name, int color)
    {
        json.Object().Text("name", name).Object("pbrMetallicRoughness")
            .Numbers("baseColorFactor", ToLinear(color >> 16), ToLinear(color >> 8), ToLinear(color), 1)
            .Number("metallicFactor", 0).Number("roughnessFactor", Roughness).EndObject().EndObject();
    }

    // glTF's colours are linear; the lowest byte is a level of sRGB.
    private static float ToLinear(int color)
    {
        float level = (color & 0xFF) / 255f;
        return level <= 0.04045f ? level / 12.92f : (float)Math.Pow((level + 0.055) / 1.055, 2.4);
    }

    private static void WriteNumbers(Stream output, params uint[] numbers)
    {
        foreach (uint number in numbers)
            output.Write([(byte)number, (byte)(number >> 8), (byte)(number >> 16), (byte)(number >> 24)], 0, 4);
    }
}
