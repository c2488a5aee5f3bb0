package org.selectiverenderer.runtime;

import java.util.List;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.runtime.instance.InstanceTree;
import org.selectiverenderer.runtime.loading.LiveFiles;
import org.selectiverenderer.runtime.loading.LoadedScene;
import org.selectiverenderer.runtime.nodes.script.ScriptNode;
import org.selectiverenderer.runtime.nodes.sound.AudioClipNode;
import org.selectiverenderer.runtime.nodes.sound.SoundNode;
import org.selectiverenderer.runtime.scene.Cascade;
import org.selectiverenderer.runtime.scene.Node;
import org.selectiverenderer.runtime.scene.Scene;
import org.selectiverenderer.runtime.script.ScriptWorld;
import org.selectiverenderer.runtime.script.Scripts;
import org.selectiverenderer.runtime.sound.Voice;

/**
 * The scene that a world shows, with all that runs in it: its layers, the files that it comes to
 * name, its scripts. Made anew when the world shows another one. Belongs to the thread that steps
 * the world.
 */
final class RunningScene {
  private final World world;
  private final Cascade cascade;
  private final Problems problems;
  final Scene scene;
  final LayerStack layers;
  final LiveFiles files;
  final Scripts scripts;
  private boolean cutOff;

  RunningScene(World world, LoadedScene loaded) {
    this.world = world;
    cascade = world.cascade();
    problems = world.problems();
    scene = loaded.scene();
    files = new LiveFiles(loaded, problems, world::post);
    AnchorLinks links = new AnchorLinks(scene, files, problems, new LinkTarget());
    layers =
        new LayerStack(
            scene,
            new LayerStack.Parts(files.assets(), world.meshes(), links::follow, cascade),
            world.viewer(),
            world.picture());
    scripts = new Scripts(new ScriptsWorld(links));
    world.keys().follow(List.of(), cascade);
    reportCutOff();
  }

  /** Lets go of what runs in it, when another scene takes its place. */
  void close() {
    layers.close();
    scripts.close();
  }

  /** Says once that a part of the scene is left out. */
  private void reportCutOff() {
    InstanceTree instances = layers.active().instances;
    if (instances.cutOff() && !cutOff) {
      cutOff = true;
      problems.error(
          Location.of(scene.url()),
          "the scene contains itself or has more than %s instances; the rest is left out"
              .formatted(instances.maxInstances()));
    }
  }

  /** Carries the events sent, and brings up to date what follows the scene. */
  void settle() {
    carry();
    layers.follow();
    layers.update();
    layers.bind(cascade);
    carry(); // Nodes that came or went may have been bound or unbound.
    layers.update();
    frameNodes();
    reportCutOff();
    files.update();
  }

  /**
   * Calls listeners and scripts until none sends anything more; scripts call each other so often.
   */
  private void carry() {
    cascade.run();
    while (scripts.finish()) {
      cascade.run();
    }
  }

  /** Follows the structure of the scene with the nodes that look at every frame. */
  void frameNodes() {
    if (layers.frameNodes()) {
      files.watch(layers.gathered(SceneLayer::inlines));
      files.watchClips(clips());
      files.watchFrameNodes(layers.gathered(SceneLayer::looking));
      scripts.watch(layers.gathered(SceneLayer::scripts));
      world.keys().follow(layers.gathered(SceneLayer::keySensors), cascade);
    }
  }

  /** What is heard as of the last step: nothing in a scene without a Sound. */
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

  /** What an Anchor may do. */
  private final class LinkTarget implements AnchorLinks.Target {
    @Override
    public void bind(Node viewpoint) {
      world.bindables().bind(viewpoint, cascade);
    }

    @Override
    public void show(LoadedScene linked) {
      world.replace(RunningScene.this, linked);
    }
  }

  /** What Scripts see of it. */
  private final class ScriptsWorld implements ScriptWorld {
    private final AnchorLinks links;

    ScriptsWorld(AnchorLinks links) {
      this.links = links;
    }

    @Override
    public Cascade cascade() {
      return cascade;
    }

    @Override
    public Problems problems() {
      return problems;
    }

    @Override
    public Scene scene() {
      return scene;
    }

    @Override
    public LiveFiles files() {
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
