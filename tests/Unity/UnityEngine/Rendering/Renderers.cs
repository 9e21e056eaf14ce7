namespace UnityEngine;

public sealed class MeshFilter : Component
{
    public Mesh? sharedMesh { get; set; }

    public Mesh? mesh
    {
        get => sharedMesh;
        set => sharedMesh = value;
    }
}

public class Renderer : Component
{
    public bool enabled { get; set; } = true;

    private Material?[] _materials = [];
    private MaterialPropertyBlock? _block;

    public Material? sharedMaterial
    {
        get => _materials.FirstOrDefault();
        set => _materials = [value, .. _materials.Skip(1)];
    }

    /// <summary>The renderer's own copy, created on first use, as in the engine.</summary>
    public Material? material
    {
        get
        {
            if (sharedMaterial is not null && !sharedMaterial.name.EndsWith("(Instance)", StringComparison.Ordinal))
                sharedMaterial = new Material(sharedMaterial) { name = sharedMaterial.name + " (Instance)" };

            return sharedMaterial;
        }

        set => sharedMaterial = value;
    }

    public Material?[] sharedMaterials
    {
        get => [.. _materials];
        set => _materials = [.. value];
    }

    public void SetPropertyBlock(MaterialPropertyBlock? properties) => _block = properties?.Copy();

    public void GetPropertyBlock(MaterialPropertyBlock properties) => properties.CopyFrom(_block);

    public bool receiveShadows { get; set; } = true;

    public Rendering.ShadowCastingMode shadowCastingMode { get; set; } = Rendering.ShadowCastingMode.On;

    public Bounds bounds { get; set; }

    public bool isVisible => enabled && gameObject.activeInHierarchy && IsInView;

    /// <summary>Whether a camera sees the renderer, which a test decides.</summary>
    internal bool IsInView { get; set; } = true;
}

public class MeshRenderer : Renderer
{
}

public class SkinnedMeshRenderer : Renderer
{
    public Mesh? sharedMesh { get; set; }

    public Transform[] bones { get; set; } = [];

    public Transform? rootBone { get; set; }

    public Bounds localBounds { get; set; }

    public bool updateWhenOffscreen { get; set; }
}

public sealed class LineRenderer : Renderer
{
    private Vector3[] _positions = [];

    public int positionCount
    {
        get => _positions.Length;
        set => Array.Resize(ref _positions, value);
    }

    public bool useWorldSpace { get; set; } = true;

    public bool loop { get; set; }

    public float startWidth { get; set; } = 1;

    public float endWidth { get; set; } = 1;

    public float widthMultiplier { get; set; } = 1;

    public Color startColor { get; set; } = Color.white;

    public Color endColor { get; set; } = Color.white;

    public void SetPosition(int index, Vector3 position) => _positions[index] = position;

    public Vector3 GetPosition(int index) => _positions[index];
}
