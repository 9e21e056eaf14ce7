namespace UnityEngine.Rendering;

public abstract class RenderPipelineAsset : ScriptableObject
{
    public virtual Shader? defaultShader => null;

    public virtual Material? defaultMaterial => null;
}

public static class GraphicsSettings
{
    /// <summary>Null for the built-in pipeline.</summary>
    public static RenderPipelineAsset? currentRenderPipeline { get; internal set; }
}
