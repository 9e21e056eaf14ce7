#nullable enable

using System;
using UnityEditor;

namespace NeuronMocap.Unity.EditorTools
{
    // Requests a repaint ten times a second while the content changes.
    internal sealed class RepaintTimer : IDisposable
    {
        private const double Interval = 0.1;

        private readonly Func<bool> _isNeeded;
        private readonly Action _repaint;
        private double _next;

        public RepaintTimer(Func<bool> isNeeded, Action repaint)
        {
            _isNeeded = isNeeded;
            _repaint = repaint;
            EditorApplication.update += OnUpdate;
        }

        public void Dispose() => EditorApplication.update -= OnUpdate;

        private void OnUpdate()
        {
            double now = EditorApplication.timeSinceStartup;
            if (now < _next || !_isNeeded())
                return;

            _next = now + Interval;
            _repaint();
        }
    }
}
