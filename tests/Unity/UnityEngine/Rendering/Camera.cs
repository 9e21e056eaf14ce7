namespace UnityEngine;

public sealed class Camera : Behaviour
{
    public static Camera? main => Object.FindObjectsOfType<Camera>().FirstOrDefault(static camera => camera.enabled && camera.CompareTag("MainCamera"));

    public float fieldOfView { get; set; } = 60;

    public float nearClipPlane { get; set; } = 0.3f;

    public float farClipPlane { get; set; } = 1000;

    public float depth { get; set; }

    public bool orthographic { get; set; }

    public float orthographicSize { get; set; } = 5;

    public Color backgroundColor { get; set; }

    public CameraClearFlags clearFlags { get; set; } = CameraClearFlags.Skybox;

    public Rect rect { get; set; } = new(0, 0, 1, 1);

    public float aspect { get; set; } = 16 / 9f;

    public int pixelWidth => 1920;

    public int pixelHeight => 1080;
}

public enum CameraClearFlags
{
    Skybox = 1,
    SolidColor = 2,
    Depth = 3,
    Nothing = 4,
}

public sealed class AudioListener : Behaviour
{
}
