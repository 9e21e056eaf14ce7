using UnityEditor.Build.Reporting;
using UnityEngine.SceneManagement;

namespace UnityEditor.Build;

public interface IOrderedCallback
{
    int callbackOrder { get; }
}

public interface IPreprocessBuildWithReport : IOrderedCallback
{
    void OnPreprocessBuild(BuildReport report);
}

public interface IPostprocessBuildWithReport : IOrderedCallback
{
    void OnPostprocessBuild(BuildReport report);
}

public interface IProcessSceneWithReport : IOrderedCallback
{
    void OnProcessScene(Scene scene, BuildReport? report);
}
