#nullable enable

using System;
using System.Linq;
using NeuronMocap.Retargeting;
using UnityEditor;
using UnityEngine;

namespace NeuronMocap.Unity.EditorTools
{
    // The file that a figure was imported from, and the import settings that can be changed.
    internal sealed class ModelFile
    {
        private readonly ModelImporter _importer;

        private ModelFile(ModelImporter importer) => _importer = importer;

        public string Path => _importer.assetPath;

        // Found by the avatar, or else by the mesh of a skin. The mesh also leads to the file when the figure was unpacked from its prefab.
        public static ModelFile? Of(Animator animator)
        {
            string path = animator.avatar != null ? AssetDatabase.GetAssetPath(animator.avatar) : string.Empty;
            if (path.Length == 0)
            {
                path = animator.GetComponentsInChildren<SkinnedMeshRenderer>(true)
                    .Select(skin => AssetDatabase.GetAssetPath(skin.sharedMesh))
                    .FirstOrDefault(found => !string.IsNullOrEmpty(found)) ?? string.Empty;
            }

            return AssetImporter.GetAtPath(path) is ModelImporter importer ? new ModelFile(importer) : null;
        }

        public Avatar? FindAvatar() => AssetDatabase.LoadAllAssetsAtPath(Path).OfType<Avatar>().FirstOrDefault();

        public void ImportAsHumanoid()
        {
            _importer.animationType = ModelImporterAnimationType.Human;
            _importer.avatarSetup = ModelImporterAvatarSetup.CreateFromThisModel;
            _importer.SaveAndReimport();
        }

        public void KeepTransforms()
        {
            _importer.optimizeGameObjects = false;
            _importer.SaveAndReimport();
        }

        // The import settings store the rest pose of a Humanoid, name by name. For a model that was never configured they are empty. Unity then finds
        // the bones at each import, and the result is in the avatar.
        public void SetRestPose(Avatar avatar, ReadOnlySpan<RigNode> nodes)
        {
            HumanDescription description = _importer.humanDescription;
            if (description.skeleton is null || description.skeleton.Length == 0)
            {
                HumanDescription found = avatar.humanDescription;
                (description.human, description.skeleton) = (found.human, found.skeleton);
            }

            var skeleton = (SkeletonBone[])description.skeleton.Clone();
            foreach (RigNode node in nodes)
            {
                string name = node.Name;
                int index = Array.FindIndex(skeleton, bone => string.Equals(bone.name, name, StringComparison.Ordinal));
                if (index < 0)
                    continue;

                skeleton[index].position = node.Position.ToUnity();
                skeleton[index].rotation = node.Rotation.ToUnity();
            }

            description.skeleton = skeleton;
            _importer.humanDescription = description;
            _importer.SaveAndReimport();
        }
    }
}
