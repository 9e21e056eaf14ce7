using NeuronMocap.Tests.Mono;

namespace NeuronMocap.Unity.Tests.Mono;

/// <summary>Runs the package's assemblies on the editor's own runtime: a source with the simulator moves a figure, then play mode ends.</summary>
public sealed class MonoPackageTests
{
    private const string Program =
        """
        using System;
        using NeuronMocap.Unity;
        using UnityEngine;
        using UnityEngine.StandIn;

        public static class Program
        {
            public static void Main()
            {
                using (var loop = new PlayerLoop())
                {
                    var root = new GameObject("Root");
                    root.SetActive(false);
                    MocapSource source = root.AddComponent<MocapSource>();
                    source.Kind = SourceKind.Simulator;
                    var child = new GameObject("Figure");
                    child.transform.SetParent(root.transform);
                    FigureBuilder figure = child.AddComponent<FigureBuilder>();
                    child.GetComponent<HumanoidDriver>().Source = source;
                    root.SetActive(true);

                    loop.RunUntil(delegate { return figure.Driver.IsDriving; });
                    // Looked up each time, because the figure is rebuilt when the performer's sizes are known.
                    Func<Vector3> hand = delegate { return figure.Figure.Animator.GetBoneTransform(HumanBodyBones.LeftHand).position; };
                    Vector3 start = hand();
                    loop.RunUntil(delegate { return (hand() - start).magnitude > 0.05f; });
                    Console.WriteLine("moved, performers: " + source.Performers.Count);

                    loop.ReloadDomain();
                    loop.RunUntil(delegate { return source.Performers.Count == 1 && figure.Driver.IsDriving; });
                    Console.WriteLine("moves after a reload");

                    loop.ExitPlayMode();
                    Console.WriteLine("ended");
                    foreach (LogEntry entry in ConsoleLog.Problems)
                        Console.WriteLine(entry);
                }
            }
        }
        """;

    // A thread that continued would keep the process alive, and the test would never see its end.
    [Fact]
    public async Task A_simulated_performer_moves_a_figure_and_nothing_is_left_after_play_mode()
    {
        MonoProgram.Require();
        using var program = new MonoProgram("UnityEngine.dll", "UnityEditor.dll", "NeuronMocap.Unity.dll");
        await program.CompileAsync(Program);

        Assert.Equal(["moved, performers: 1", "moves after a reload", "ended"], await program.RunAsync());
    }
}
