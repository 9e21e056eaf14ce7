using UnityEngine;

namespace UnityEditor;

public class ModelImporter : AssetImporter
{
    public ModelImporterAnimationType animationType { get; set; } = ModelImporterAnimationType.Generic;

    public ModelImporterAvatarSetup avatarSetup { get; set; }

    public bool optimizeGameObjects { get; set; }

    public HumanDescription humanDescription { get; set; }
}
