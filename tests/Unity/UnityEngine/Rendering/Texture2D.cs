namespace UnityEngine;

public abstract class Texture : Object
{
    public int width { get; private protected set; }

    public int height { get; private protected set; }

    public TextureWrapMode wrapMode { get; set; }

    public FilterMode filterMode { get; set; } = FilterMode.Bilinear;

    public int anisoLevel { get; set; } = 1;
}

public sealed class Texture2D : Texture
{
    private Color32[]? _pixels;

    public Texture2D(int width, int height)
        : this(width, height, TextureFormat.RGBA32, true)
    {
    }

    public Texture2D(int width, int height, TextureFormat textureFormat, bool mipChain)
    {
        this.width = width;
        this.height = height;
        format = textureFormat;
        mipmapCount = mipChain ? 1 + (int)Math.Log(Math.Max(width, height), 2) : 1;
        _pixels = new Color32[width * height];
    }

    public TextureFormat format { get; }

    public int mipmapCount { get; }

    public bool isReadable => _pixels is not null;

    public void SetPixels32(Color32[] colors)
    {
        if (colors.Length != Readable.Length)
            throw new ArgumentException("The array has another size than the texture.", nameof(colors));

        _pixels = [.. colors];
    }

    public Color32[] GetPixels32() => [.. Readable];

    public void Apply() => Apply(true, false);

    public void Apply(bool updateMipmaps, bool makeNoLongerReadable)
    {
        _ = Readable;
        if (makeNoLongerReadable)
            _pixels = null;
    }

    private Color32[] Readable => _pixels ?? throw new UnityException($"Texture '{name}' is not readable.");
}

public enum TextureFormat
{
    RGB24 = 3,
    RGBA32 = 4,
}

public enum TextureWrapMode
{
    Repeat,
    Clamp,
    Mirror,
}

public enum FilterMode
{
    Point,
    Bilinear,
    Trilinear,
}
