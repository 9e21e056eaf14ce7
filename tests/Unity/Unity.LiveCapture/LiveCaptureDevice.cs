using UnityEngine;

namespace Unity.LiveCapture;

[ExecuteAlways]
[DisallowMultipleComponent]
public abstract class LiveCaptureDevice : MonoBehaviour
{
    public bool IsRecording { get; private set; }

    public abstract bool IsReady();

    public abstract void Write(ITakeBuilder takeBuilder);

    protected virtual void OnEnable() => TakeRecorder.Devices.Add(this);

    protected virtual void OnDisable()
    {
        StopRecording();
        TakeRecorder.Devices.Remove(this);
    }

    protected virtual void UpdateDevice()
    {
    }

    protected virtual void LiveUpdate()
    {
    }

    protected virtual void OnStartRecording()
    {
    }

    protected virtual void OnStopRecording()
    {
    }

    internal void StartRecording()
    {
        if (IsRecording || !isActiveAndEnabled || !IsReady())
            return;

        IsRecording = true;
        OnStartRecording();
    }

    internal void StopRecording()
    {
        if (!IsRecording)
            return;

        IsRecording = false;
        OnStopRecording();
    }
}
