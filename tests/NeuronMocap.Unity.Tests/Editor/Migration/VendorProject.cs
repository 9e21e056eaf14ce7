using UnityEditor;

namespace NeuronMocap.Unity.Tests.Editor.Migration;

/// <summary>A project in a folder of its own, with or without the vendor's scripts.</summary>
internal sealed class VendorProject : IDisposable
{
    public const string AnimatorGuid = "41173daca41f9a64b8552925c6a3c363";
    public const string TransformsGuid = "b9f969a3a049578478f71ba66294d9d5";
    public const string UnknownGuid = "00000000000000000000000000000abc";

    private readonly string _folder = Application.Folder;

    public VendorProject(bool hasScripts)
    {
        Application.Folder = Directory.CreateTempSubdirectory("vendor").FullName;
        AssetDatabase.Clear();
        if (!hasScripts)
            return;

        AssetDatabase.AddScript(AnimatorGuid, typeof(NeuronAnimatorInstance));
        AssetDatabase.AddScript(TransformsGuid, typeof(Neuron.NeuronTransformsInstance));
    }

    public EditorWorld World { get; } = new();

    /// <summary>Returns a file in Unity's text format.</summary>
    public static string File(params string[] entries) => "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n" + string.Concat(entries);

    /// <summary>Returns an object with a transform, whose numbers are <paramref name="id"/> and the next one.</summary>
    public static string Object(long id, string name, long father = 0) => $$"""
        --- !u!1 &{{id}}
        GameObject:
          m_Component:
          - component: {fileID: {{id + 1}}}
          m_Name: {{name}}
          m_IsActive: 1
        --- !u!4 &{{id + 1}}
        Transform:
          m_GameObject: {fileID: {{id}}}
          m_LocalPosition: {x: 0, y: 0, z: 0}
          m_Father: {fileID: {{father}}}

        """;

    /// <summary>Returns a script on an object.</summary>
    public static string Script(long id, long owner, string guid, params string[] fields) => $$"""
        --- !u!114 &{{id}}
        MonoBehaviour:
          m_GameObject: {fileID: {{owner}}}
          m_Enabled: 1
          m_Script: {fileID: 11500000, guid: {{guid}}, type: 3}
          m_Name: 

        """ + string.Concat(fields.Select(static field => $"  {field}\n"));

    public static string Animator(long id, long owner) => $$"""
        --- !u!95 &{{id}}
        Animator:
          m_GameObject: {fileID: {{owner}}}

        """;

    /// <summary>Returns an instance of a prefab that changes fields of an object of the prefab.</summary>
    public static string Instance(long id, string prefab, long target = 0, params (string Field, string Value)[] changes) => $$"""
        --- !u!1001 &{{id}}
        PrefabInstance:
          m_ObjectHideFlags: 0
          m_Modification:
            m_TransformParent: {fileID: 0}
            m_Modifications:

        """ + string.Concat(changes.Select(change => $$"""
                - target: {fileID: {{target}}, guid: {{prefab}}, type: 3}
                  propertyPath: {{change.Field}}
                  value: {{change.Value}}
                  objectReference: {fileID: 0}

            """)) + $$"""
          m_SourcePrefab: {fileID: 100100000, guid: {{prefab}}, type: 3}

        """;

    /// <summary>Returns an entry that stands for an object of an instance.</summary>
    public static string Stub(int type, long id, long source, string prefab, long instance) => $$"""
        --- !u!{{type}} &{{id}} stripped
        Stub:
          m_CorrespondingSourceObject: {fileID: {{source}}, guid: {{prefab}},
            type: 3}
          m_PrefabInstance: {fileID: {{instance}}}

        """;

    public static string Read(string path) => System.IO.File.ReadAllText(AssetDatabase.ToFile(path));

    public void Dispose()
    {
        World.Dispose();
        AssetDatabase.Clear();
        Directory.Delete(Application.Folder, recursive: true);
        Application.Folder = _folder;
    }
}
