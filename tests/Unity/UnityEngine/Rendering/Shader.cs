namespace UnityEngine;

/// <summary>The shaders of a project: by default those of the built-in pipeline. Each exists once.</summary>
public sealed class Shader : Object
{
    private static readonly Dictionary<string, int> _ids = [];
    private static readonly Dictionary<string, Shader> _known = [];

    private Shader()
    {
    }

    public bool isSupported => true;

    /// <summary>Names of the shaders in the project, or in the player.</summary>
    internal static HashSet<string> Available { get; } = ["Standard", "Sprites/Default", "Hidden/Internal-Colored", "Hidden/InternalErrorShader"];

    internal string MainColor => IsOfPipeline ? "_BaseColor" : "_Color";

    internal string MainTexture => IsOfPipeline ? "_BaseMap" : "_MainTex";

    private bool IsOfPipeline => name.StartsWith("Universal Render Pipeline/", StringComparison.Ordinal) || name.StartsWith("HDRP/", StringComparison.Ordinal);

    public static Shader? Find(string name)
    {
        if (!Available.Contains(name))
            return null;

        if (!_known.TryGetValue(name, out Shader? shader) || shader.IsDestroyed)
            _known[name] = shader = new Shader { name = name };

        return shader;
    }

    public static int PropertyToID(string name)
    {
        lock (_ids)
        {
            if (!_ids.TryGetValue(name, out int id))
                _ids.Add(name, id = _ids.Count + 1);

            return id;
        }
    }

    internal bool Has(int property) => property == PropertyToID(MainColor) || property == PropertyToID(MainTexture)
        || property == PropertyToID(IsOfPipeline ? "_Smoothness" : "_Glossiness");
}
