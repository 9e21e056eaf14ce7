#nullable enable

using System;
using System.Collections.Generic;
using System.Linq;
using UnityEditor;
using UnityEditor.SceneManagement;
using UnityEngine;
using UnityEngine.SceneManagement;

namespace NeuronMocap.Unity.EditorTools
{
    // Puts the package's components in the place of the vendor's: in the open scenes, and in the scenes and prefabs below Assets. The dry run follows
    // the same path and only leaves the changes out. Undo restores open scenes and prefabs. Other scenes are opened, saved and closed.
    internal sealed class Migration
    {
        private const string UndoName = "Convert Vendor Components";

        private readonly bool _applies;
        private readonly IReadOnlyDictionary<string, VendorScript> _guids = VendorScripts.FindGuids();
        private readonly List<MigrationItem> _items = new List<MigrationItem>();

        private Migration(bool applies) => _applies = applies;

        // Changes nothing.
        public static IReadOnlyList<MigrationItem> Examine() => new Migration(applies: false).Run();

        public static IReadOnlyList<MigrationItem> Convert() => new Migration(applies: true).Run();

        private IReadOnlyList<MigrationItem> Run()
        {
            string[] scenes = Find("t:Scene");
            string[] prefabs = Find("t:Prefab");
            Dictionary<string, string> affected = prefabs.Where(IsAffected).ToDictionary(path => AssetDatabase.AssetPathToGUID(path), StringComparer.Ordinal);
            foreach (string path in scenes.Concat(prefabs))
                ReportInstances(path, affected);

            // Closing a scene may end steps of Undo, so scenes that are not open come first.
            Scene[] open = Enumerable.Range(0, SceneManager.sceneCount).Select(index => SceneManager.GetSceneAt(index)).Where(scene => scene.isLoaded).ToArray();
            foreach (string path in scenes.Where(path => open.All(scene => !string.Equals(scene.path, path, StringComparison.Ordinal))).Where(IsAffected))
                VisitClosed(path);

            Undo.IncrementCurrentGroup();
            int group = Undo.GetCurrentGroup();
            foreach (Scene scene in open)
            {
                if (Visit(new MigrationFile(scene)))
                    EditorSceneManager.MarkSceneDirty(scene);
            }

            // After the scenes, because their instances lose what their prefabs lose.
            foreach (string path in affected.Values)
                VisitPrefab(path);

            if (_applies)
            {
                Undo.SetCurrentGroupName(UndoName);
                Undo.CollapseUndoOperations(group);
            }

            return _items;
        }

        // Packages are read-only. Unity takes models for prefabs, too, but their files hold no components.
        private static string[] Find(string filter) => AssetDatabase.FindAssets(filter, new[] { "Assets" })
            .Select(guid => AssetDatabase.GUIDToAssetPath(guid)).Where(IsText).Distinct(StringComparer.Ordinal).OrderBy(path => path, StringComparer.Ordinal).ToArray();

        private static bool IsText(string path) =>
            path.EndsWith(".unity", StringComparison.OrdinalIgnoreCase) || path.EndsWith(".prefab", StringComparison.OrdinalIgnoreCase);

        private bool IsAffected(string path) => YamlFile.Read(path) is { } text && _guids.Keys.Any(text.Mentions);

        // An instance keeps the values that it changes in its own file. They have no place in the new components.
        private void ReportInstances(string path, Dictionary<string, string> affected)
        {
            if (!(YamlFile.Read(path) is { } text))
                return;

            if (!text.IsText)
                _items.Add(new MigrationItem(path, "Whole file", string.Empty, "It is binary. Set Asset Serialization to Force Text in the project settings, and search again."));

            if (!affected.Keys.Any(text.Mentions))
                return;

            foreach (IGrouping<string, PrefabChange> changes in text.Changes
                .Where(change => affected.ContainsKey(change.Prefab) && VendorSettings.FieldNames.Contains(change.Field, StringComparer.Ordinal))
                .GroupBy(change => change.Prefab, StringComparer.Ordinal))
            {
                string fields = string.Join(", ", changes.Select(change => $"{change.Field} = {change.Value}"));
                _items.Add(new MigrationItem(path, $"Instance of {affected[changes.Key]}", string.Empty, $"The instance changes {fields}. Make the same changes on its new components."));
            }
        }

        private void VisitClosed(string path)
        {
            Scene scene = EditorSceneManager.OpenScene(path, OpenSceneMode.Additive);
            try
            {
                if (Visit(new MigrationFile(scene)) && !EditorSceneManager.SaveScene(scene))
                    _items.Add(new MigrationItem(path, "Whole file", string.Empty, "It could not be saved, so nothing in it has changed."));
            }
            finally
            {
                EditorSceneManager.CloseScene(scene, true);
            }
        }

        private void VisitPrefab(string path)
        {
            GameObject? prefab = AssetDatabase.LoadAssetAtPath<GameObject>(path);
            if (prefab == null || !Visit(new MigrationFile(path, prefab)))
                return;

            PrefabUtility.SavePrefabAsset(prefab, out bool isSaved);
            if (!isSaved)
                _items.Add(new MigrationItem(path, "Whole file", string.Empty, "It could not be saved, so its file has not changed."));
        }

        // Returns whether the file has changed.
        private bool Visit(MigrationFile file)
        {
            var sources = new SourcePlacement(file);
            var driven = new HashSet<GameObject>();
            foreach (VendorComponent component in VendorComponent.FindAll(file, _guids))
            {
                var settings = new VendorSettings(component);
                string place = $"{(component.Owner != null ? PathOf(component.Owner.transform) : "An object")}: {component.Script.Name}";
                string reason = FindReason(component, settings, sources, driven);
                if (reason.Length > 0)
                {
                    _items.Add(new MigrationItem(file.Name, place, string.Empty, reason));
                    continue;
                }

                driven.Add(component.Owner!);
                bool isNew = sources.Plan(settings.Source, component.Owner!);
                string driver = component.Script.Kind == VendorKind.Humanoid ? "Humanoid Driver" : "Generic Rig Driver";
                string change = $"{driver}, performer {settings.Performer} of {(isNew ? "a new Mocap Source" : "the Mocap Source")}, {settings.Source}";
                _items.Add(new MigrationItem(file.Name, place, change, notes: settings.Notes));
                if (_applies)
                    Replace(component, settings, sources);
            }

            return _applies && driven.Count > 0;
        }

        private static string FindReason(VendorComponent component, VendorSettings settings, SourcePlacement sources, HashSet<GameObject> driven)
        {
            if (component.Script.Kind == VendorKind.None)
                return component.Script.Reason;
            if (component.FindObstacle() is { Length: > 0 } obstacle)
                return obstacle;
            if (settings.FindObstacle() is { Length: > 0 } fault)
                return fault;

            return driven.Contains(component.Owner!) || component.Owner!.GetComponent<FigureDriver>() != null
                ? "The object already has a driver. Remove one of the two components."
                : sources.FindObstacle(settings.Source, component.Owner!);
        }

        private static void Replace(VendorComponent component, VendorSettings settings, SourcePlacement sources)
        {
            GameObject owner = component.Owner!;
            FigureDriver driver = component.Script.Kind == VendorKind.Humanoid
                ? Undo.AddComponent<HumanoidDriver>(owner)
                : (FigureDriver)Undo.AddComponent<GenericRigDriver>(owner);
            driver.Source = sources.Create(settings.Source, owner);
            settings.CopyTo(driver);
            EditorUtility.SetDirty(driver);
            component.Remove();
        }

        private static string PathOf(Transform transform) => transform.parent == null ? transform.name : $"{PathOf(transform.parent)}/{transform.name}";
    }
}
