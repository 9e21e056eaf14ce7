#nullable enable
using System;
using System.IO;
using UnityEngine;

namespace NeuronMocap.Unity
{
    // A take, from its first frame to its file.
    public sealed partial class ClipRecorder
    {
        // A frame that comes slightly early is taken anyway.
        private const float EarlyPart = 0.25f;

        private ClipSampler? _sampler;
        private float _time;
        private float _nextTime;

        // Whether the character is this object or below it, so that another one can take its place.
        private bool _isBelow;

        /// <summary>Ends the take and, in the editor, saves it.</summary>
        public override void StopRecording()
        {
            if (_sampler is null)
                return;

            _sampler.Dispose();
            _sampler = null;
            Handlers.Raise(Finished, Take!, this);
            Save(Take!);
        }

        private protected override string Begin()
        {
            Animator? animator = _animator != null ? _animator : GetComponentInChildren<Animator>();
            _sampler = ClipSamplers.Create(_kind, animator, transform, _hips, out string problem);
            if (_sampler is null)
                return problem;

            _isBelow = animator != null && animator.transform.IsChildOf(transform);
            SavedPath = "";
            Take = new ClipTake(_sampler.Properties, _kind == ClipKind.Humanoid, _frameRate);
            _time = 0;
            _nextTime = 0;
            return "";
        }

        private void LateUpdate()
        {
            if (_sampler is null || Take is null)
                return;

            if (_sampler.IsGone && !TryFollow())
            {
                StopRecording();
                if (Problem.Length == 0)
                    Problem = "The take has ended early, because its character was destroyed.";

                return;
            }

            if (Take.FrameCount > 0)
                _time += FrameTime.Delta;

            float period = 1 / _frameRate;
            if (_time < _nextTime - (EarlyPart * period))
                return;

            _nextTime = Mathf.Max(_nextTime + period, _time);
            _sampler.Sample();
            Take.Add(_time, _sampler.Values);
        }

        private void OnDisable() => StopRecording();

        // A figure that was built again for other sizes is another object in the same place.
        private bool TryFollow()
        {
            Animator? animator = _isBelow ? GetComponentInChildren<Animator>() : null;
            ClipKind kind = Take!.IsHumanoid ? ClipKind.Humanoid : ClipKind.Generic;
            ClipSampler? next = animator != null ? ClipSamplers.Replace(_sampler!, kind, animator, _hips) : null;
            if (next is null)
                return false;

            _sampler!.Dispose();
            _sampler = next;
            return true;
        }

        private void Save(ClipTake take)
        {
            if (take.FrameCount == 0)
            {
                Problem = "Nothing was recorded: the take ended before the first frame.";
                return;
            }

            if (Saver is null)
            {
                Problem = "Only the editor can save clips. In a player, Motion Recorder writes BVH.";
                return;
            }

            try
            {
                SavedPath = Saver(this, take);
                CountUp();
            }
            catch (Exception exception) when (exception is IOException || exception is UnauthorizedAccessException || exception is ArgumentException)
            {
                Problem = "The clip was not saved: " + exception.Message;
            }
        }
    }
}
