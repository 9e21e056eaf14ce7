#nullable enable

using System;
using System.Collections.Generic;
using System.Linq;
using UnityEditor;
using UnityEngine;

namespace NeuronMocap.Unity.EditorTools
{
    // Tools, NeuronMocap, Convert Vendor Components: lists what would change before anything does, then what has changed.
    internal sealed class MigrationWindow : EditorWindow
    {
        public const string Menu = "Tools/NeuronMocap/Convert Vendor Components";
        public const string SearchAgain = "Search Again";
        public const string Convert = "Convert";

        private const string Explanation =
            "Undo restores open scenes and prefabs. Scenes that are not open are saved at once, so commit or copy the project first. References of other "
            + "components to the vendor's components become empty.";

        private IReadOnlyList<MigrationItem> _items = Array.Empty<MigrationItem>();
        private string _title = "Not searched yet";
        private bool _isDone;
        private Vector2 _scroll;

        internal IReadOnlyList<MigrationItem> Items => _items;

        [MenuItem(Menu)]
        public static MigrationWindow Open()
        {
            MigrationWindow window = GetWindow<MigrationWindow>();
            window.Search();
            return window;
        }

        // Changes in play mode are lost.
        [MenuItem(Menu, true)]
        public static bool CanOpen() => !Application.isPlaying;

        private void OnEnable()
        {
            titleContent = new GUIContent("Convert Vendor Components");
            minSize = new Vector2(480f, 320f);
        }

        private void OnGUI()
        {
            ReportGui.Headline(_items.Count == 0 ? Severity.Good : Severity.None, _title);
            if (!_isDone && _items.Count > 0)
                ReportGui.Message(Severity.None, Explanation);

            _scroll = EditorGUILayout.BeginScrollView(_scroll);
            foreach (IGrouping<string, MigrationItem> file in _items.GroupBy(item => item.File, StringComparer.Ordinal))
            {
                EditorGUILayout.LabelField(file.Key, EditorStyles.boldLabel);
                foreach (MigrationItem item in file)
                    Draw(item);
            }

            EditorGUILayout.EndScrollView();
            DrawButtons();
        }

        private static void Draw(MigrationItem item)
        {
            ReportGui.Step(new ReportRow(item.Place, item.IsConvertible ? item.Change : item.Reason, item.IsConvertible ? Severity.Good : Severity.Warning));
            foreach (string note in item.Notes)
                ReportGui.Message(Severity.None, note);
        }

        private void DrawButtons()
        {
            bool searches;
            bool converts;
            using (new EditorGUI.DisabledScope(Application.isPlaying))
            using (new EditorGUILayout.HorizontalScope())
            {
                searches = GUILayout.Button(SearchAgain);
                using (new EditorGUI.DisabledScope(_isDone || !_items.Any(item => item.IsConvertible)))
                    converts = GUILayout.Button(Convert);
            }

            if (searches)
                Search();
            else if (converts)
                Apply();
        }

        private void Search()
        {
            _items = Migration.Examine();
            _isDone = false;
            int convertible = _items.Count(item => item.IsConvertible);
            _title = _items.Count == 0 ? "The project has no vendor components." : $"{Count(convertible)} can be converted, {Count(_items.Count - convertible)} cannot.";
        }

        private void Apply()
        {
            _items = Migration.Convert();
            _isDone = true;
            int converted = _items.Count(item => item.IsConvertible);
            _title = $"{Count(converted)} converted, {Count(_items.Count - converted)} left.";
            Debug.Log($"NeuronMocap: {_title}{string.Concat(_items.Select(item => Environment.NewLine + item))}");
        }

        private static string Count(int count) => count == 1 ? "1 component" : $"{count} components";
    }
}
