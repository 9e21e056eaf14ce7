#nullable enable

using System;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.SceneManagement;

namespace NeuronMocap.Unity.EditorTools
{
    // A player contains only the shaders of materials that are in the build. Figures and grounds are built at run time, so the components that build
    // them get the material of the render pipeline. The scene of the build is a copy.
    internal static class BuildMaterials
    {
        public static void Add(Scene scene)
        {
            RenderPipelineAsset? pipeline = GraphicsSettings.currentRenderPipeline;
            Material? material = pipeline != null ? pipeline.defaultMaterial : null;
            if (material == null)
                return;

            ForEach<FigureBuilder>(scene, builder => builder.Look.Material = Fill(builder.Look.Material, material));
            ForEach<PerformerSpawner>(scene, spawner => spawner.Material = Fill(spawner.Material, material));
            ForEach<StageBuilder>(scene, stage => stage.GroundMaterial = Fill(stage.GroundMaterial, material));
        }

        private static Material Fill(Material? chosen, Material other) => chosen != null ? chosen : other;

        private static void ForEach<T>(Scene scene, Action<T> change)
        {
            foreach (GameObject root in scene.GetRootGameObjects())
            {
                foreach (T component in root.GetComponentsInChildren<T>(true))
                    change(component);
            }
        }
    }
}
