#nullable enable

using System;
using System.Collections.Generic;
using System.Linq;
using UnityEditor;
using UnityEngine;

namespace NeuronMocap.Unity.EditorTools
{
    // Window, NeuronMocap, Sources: the performers, how well their frames arrive, and a preview without any figure.
    internal sealed class SourcesWindow : EditorWindow
    {
        private const float SmallestPreview = 160f;

        private readonly Dictionary<MocapSource, SourcePanel> _panels = new Dictionary<MocapSource, SourcePanel>();
        private readonly SkeletonPreview _preview = new SkeletonPreview();
        private IReadOnlyList<MocapSource> _sources = Array.Empty<MocapSource>();
        private RepaintTimer? _timer;
        private SerializedObject? _takes;
        private Vector2 _scroll;

        // The performer in the preview. Performers are created again when a source reopens; their number stays the same.
        private MocapSource? _shownSource;
        private int _shownAvatar = -1;

        internal SkeletonPreview Preview => _preview;

        internal IReadOnlyList<MocapSource> Sources => _sources;

        internal Performer? Shown => _shownSource != null && _shownSource.TryGetPerformer(_shownAvatar, out Performer? performer)
            ? performer
            : _sources.Where(source => source != null).SelectMany(source => source.Performers).FirstOrDefault();

        [MenuItem("Window/NeuronMocap/Sources", priority = 3000)]
        public static SourcesWindow Open() => GetWindow<SourcesWindow>();

        private void OnEnable()
        {
            titleContent = new GUIContent("Mocap Sources");
            minSize = new Vector2(320f, 360f);
            _timer = new RepaintTimer(() => Application.isPlaying || LivePreview.IsOn || _panels.Values.Any(panel => panel.IsDirty), Repaint);
            EditorApplication.hierarchyChanged += FindSources;
            EditorApplication.playModeStateChanged += OnPlayModeChanged;
            FindSources();
        }

        private void OnDisable()
        {
            EditorApplication.hierarchyChanged -= FindSources;
            EditorApplication.playModeStateChanged -= OnPlayModeChanged;
            LivePreview.StopAll();
            _timer?.Dispose();
            foreach (SourcePanel panel in _panels.Values)
                panel.Dispose();

            _panels.Clear();
        }

        private void OnGUI()
        {
            _scroll = EditorGUILayout.BeginScrollView(_scroll);
            if (_sources.Count > 0)
                DrawTakeSettings();

            foreach (MocapSource source in _sources)
            {
                if (source != null)
                    DrawSource(source);
            }

            if (_sources.Count == 0)
                EditorGUILayout.HelpBox("The open scenes have no source. Add one with GameObject > NeuronMocap > Source.", MessageType.Info);

            EditorGUILayout.EndScrollView();
            DrawPreview();
        }

        // What the Record buttons record.
        private void DrawTakeSettings()
        {
            TakeSettings settings = TakeSettings.instance;
            FieldDrawing.MakeEditable(settings);
            if (_takes is null || _takes.targetObject != settings)
                _takes = new SerializedObject(settings);

            _takes.Update();
            FieldDrawing.Draw(_takes, name => name is "_clipKind" && _takes.Is("_clips", false));
            if (_takes.ApplyModifiedProperties())
                settings.Save();

            EditorGUILayout.LabelField("Next take", settings.NextName);
            EditorGUILayout.Space();
        }

        private void DrawSource(MocapSource source)
        {
            if (!_panels.TryGetValue(source, out SourcePanel? panel))
                _panels.Add(source, panel = new SourcePanel(source));

            if (panel.Draw(Shown) is { } chosen)
                (_shownSource, _shownAvatar) = (source, chosen.AvatarIndex);

            EditorGUILayout.Space();
        }

        private void DrawPreview()
        {
            using (new EditorGUILayout.HorizontalScope(EditorStyles.toolbar))
            {
                EditorGUILayout.LabelField(Shown is { } shown ? $"{shown.Name} ({shown.AvatarIndex})" : "No performer to show");
                if (GUILayout.Button("Front", EditorStyles.toolbarButton))
                    _preview.View.LookFromFront();
                if (GUILayout.Button("Side", EditorStyles.toolbarButton))
                    _preview.View.LookFromSide();
            }

            Rect rect = GUILayoutUtility.GetRect(SmallestPreview, SmallestPreview, GUILayout.ExpandWidth(true), GUILayout.ExpandHeight(true));
            _preview.Draw(rect, Shown);
        }

        private void FindSources()
        {
            _sources = SceneSources.Find();
            foreach (MocapSource gone in _panels.Keys.Where(source => source == null || !_sources.Contains(source)).ToArray())
            {
                _panels[gone].Dispose();
                _panels.Remove(gone);
            }

            Repaint();
        }

        private void OnPlayModeChanged(PlayModeStateChange change) => FindSources();
    }
}
