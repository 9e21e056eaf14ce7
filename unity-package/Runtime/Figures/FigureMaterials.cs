#nullable enable
using UnityEngine;
using UnityEngine.Rendering;

namespace NeuronMocap.Unity
{
    // A plain lit material for the render pipeline of the project.
    internal static class FigureMaterials
    {
        private static readonly int BaseColor = Shader.PropertyToID("_BaseColor");
        private static readonly int LegacyColor = Shader.PropertyToID("_Color");
        private static readonly int Smoothness = Shader.PropertyToID("_Smoothness");
        private static readonly int Glossiness = Shader.PropertyToID("_Glossiness");

        private static readonly string[] PipelineShaders =
        {
            "Universal Render Pipeline/Lit",
            "HDRP/Lit",
            "Universal Render Pipeline/Simple Lit",
            "Universal Render Pipeline/Unlit",
            "HDRP/Unlit",
        };

        private static readonly string[] BuiltInShaders =
        {
            "Standard",
            "Mobile/Diffuse",
            "Legacy Shaders/Diffuse",
            "Unlit/Color",
        };

        // Always in a player, in any pipeline; unlit.
        private static readonly string[] LastResorts = { "Sprites/Default", "UI/Default", "Hidden/InternalErrorShader" };

        private static bool _hasWarned;

        public static Material Create(Material? template, Color color, string name)
        {
            Material material = template != null ? new Material(template) : new Material(FindShader());
            material.name = name;
            SetColor(material, BaseColor, color);
            SetColor(material, LegacyColor, color);
            if (template == null)
            {
                SetFloat(material, Smoothness, 0.35f);
                SetFloat(material, Glossiness, 0.35f);
            }

            return material;
        }

        private static Shader FindShader()
        {
            RenderPipelineAsset? pipeline = GraphicsSettings.currentRenderPipeline;
            Shader? shader = pipeline == null ? null : pipeline.defaultShader;
            if (shader == null)
                shader = Find(pipeline == null ? BuiltInShaders : PipelineShaders);
            if (shader == null)
            {
                shader = Find(LastResorts);
                Warn();
            }

            return shader!;
        }

        // Without a reload of scripts, a new game would say nothing.
        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        private static void Forget() => _hasWarned = false;

        private static void Warn()
        {
            if (_hasWarned)
                return;

            _hasWarned = true;
            Debug.LogWarning("NeuronMocap: this player has no lit shader of its render pipeline, so built figures and the ground are flat. Set a Material in "
                + "the Look of Figure Builder, in Performer Spawner, or as Ground Material of Stage Builder.");
        }

        private static Shader? Find(string[] names)
        {
            foreach (string name in names)
            {
                Shader? shader = Shader.Find(name);
                if (shader != null)
                    return shader;
            }

            return null;
        }

        private static void SetColor(Material material, int property, Color color)
        {
            if (material.HasProperty(property))
                material.SetColor(property, color);
        }

        private static void SetFloat(Material material, int property, float value)
        {
            if (material.HasProperty(property))
                material.SetFloat(property, value);
        }
    }
}
