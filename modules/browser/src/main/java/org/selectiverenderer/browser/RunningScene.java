package org.selectiverenderer.browser;

import java.util.List;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.instance.InstanceTree;
import org.selectiverenderer.browser.loading.LoadedScene;
import org.selectiverenderer.browser.loading.RunningSceneLoader;
import org.selectiverenderer.browser.nodes.script.ScriptNode;
import org.selectiverenderer.browser.nodes.sound.AudioClipNode;
import org.selectiverenderer.browser.nodes.sound.SoundNode;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.Scene;
import org.selectiverenderer.browser.script.ScriptHost;
import org.selectiverenderer.browser.script.ScriptScheduler;
import org.selectiverenderer.browser.sound.Voice;

/**
 * The scene that a world shows, with everything that runs in it: its layers, the files that it
 * loads while it runs, and its scripts. A new one is made when the world shows another scene.
 * Belongs to the thread that steps the world.
 */
final class RunningScene {
  private final World world;
  private final EventCascade cascade;
  private final ProblemCollector problems;
  final Scene scene;
  final LayerStack layers;
  final RunningSceneLoader files;
  final ScriptScheduler scripts;
  private boolean cutOff;

  RunningScene(World world, LoadedScene loaded) {
    this.world = world;
    cascade = world.cascade();
    problems = world.problems();
    scene = loaded.scene();
    files = new RunningSceneLoader(loaded, problems, world::post, world.meshes()::add);
    AnchorHandler links = new AnchorHandler(scene, files, problems, new LinkTarget());
    layers =
        new LayerStack(
            scene,
            new LayerStack.Parts(files.assets(), world.meshes(), links::follow, cascade),
            world.viewer(),
            world.picture());
    scripts = new ScriptScheduler(new ScriptsWorld(links), world.scriptTime());
    world.keys().follow(List.of(), cascade);
    reportCutOff();
  }

  /** Stops everything that runs in the scene; called when another scene replaces it. */
  void close() {
    layers.close();
    scripts.close();
  }

  /** Reports once that a part of the scene is left out. */
  private void reportCutOff() {
    InstanceTree instances = layers.active().instances;
    if (instances.cutOff() && !cutOff) {
      cutOff = true;
      problems.error(
          SourceLocation.of(scene.url()),
          "the scene contains itself or has more than %s instances; the rest is left out"
              .formatted(instances.maxInstances()));
    }
  }

  /** Delivers the events sent and brings layers, bindings and files up to date. */
  void settle() {
    carry();
    layers.follow();
    layers.update();
    layers.bind(cascade);
    carry(); // Added and removed nodes may have been bound or unbound.
    layers.update();
    frameNodes();
    reportCutOff();
    files.update();
  }

  /**
   * Calls listeners and scripts until no more events are sent; the number of rounds in which
   * scripts may call each other is limited.
   */
  private void carry() {
    cascade.run();
    while (scripts.finish()) {
      cascade.run();
    }
  }

  /** Collects the nodes that are updated per frame, if the structure of the scene has changed. */
  void frameNodes() {
    if (layers.frameNodes()) {
      files.watch(layers.gathered(SceneLayer::inlines));
      files.watchClips(clips());
      files.watchFrameNodes(layers.gathered(SceneLayer::looking));
      scripts.watch(layers.gathered(SceneLayer::scripts));
      world.keys().follow(layers.gathered(SceneLayer::keySensors), cascade);
    }
  }

  /**
   * Returns the voices that are audible as of the last step; none in a scene without a Sound node.
   */
  List<Voice> voices() {
    List<SoundNode> sounds = layers.gathered(SceneLayer::sounds);
    return sounds.isEmpty()
        ? List.of()
        : sounds.stream().flatMap(sound -> sound.voice().stream()).toList();
  }

  private List<AudioClipNode> clips() {
    return layers.gathered(SceneLayer::sounds).stream()
        .flatMap(sound -> sound.clip().stream())
        .toList();
  }

  /** The changes that an Anchor may make to this world. */
  private final class LinkTarget implements AnchorHandler.Target {
    @Override
    public void bind(Node viewpoint) {
      world.bindables().bind(viewpoint, cascade);
    }

    @Override
    public void show(LoadedScene linked) {
      world.replace(RunningScene.this, linked);
    }
  }

  /** The running scene as Scripts see it. */
  private final class ScriptsWorld implements ScriptHost {
    private final AnchorHandler links;

    ScriptsWorld(AnchorHandler links) {
      this.links = links;
    }

    @Override
    public EventCascade cascade() {
      return cascade;
    }

    @Override
    public ProblemCollector problems() {
      return problems;
    }

    @Override
    public Scene scene() {
      return scene;
    }

    @Override
    public RunningSceneLoader files() {
      return files;
    }

    @Override
    public void show(LoadedScene wanted) {
      world.post(() -> world.replace(wanted));
    }

    @Override
    public void follow(ScriptNode script, String[] urls) {
      Scene file = script.context();
      world.post(() -> links.follow(script, urls, file == null ? scene : file));
    }
  }
}
