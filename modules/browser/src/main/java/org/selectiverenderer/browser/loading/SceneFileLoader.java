package org.selectiverenderer.browser.loading;

import java.io.IOException;
import java.io.InputStream;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Consumer;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.browser.instance.Background;
import org.selectiverenderer.browser.loading.LoadedFile.Outcome;
import org.selectiverenderer.browser.movie.MovieDecoderPool;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.read.NodeTraversal;
import org.selectiverenderer.x3d.read.ParsedNode;
import org.selectiverenderer.x3d.read.PrototypeLibrary;
import org.selectiverenderer.x3d.read.PrototypeLibraryLoader;
import org.selectiverenderer.x3d.read.PrototypeLibraryProvider;
import org.selectiverenderer.x3d.read.X3dFile;
import org.selectiverenderer.x3d.read.X3dReader;
import org.selectiverenderer.x3d.script.ScriptProgram;
import org.selectiverenderer.x3d.script.ScriptProgramSelection;
import org.selectiverenderer.x3d.tessellate.Tessellator;
import org.selectiverenderer.x3d.url.BaseUrl;
import org.selectiverenderer.x3d.url.IoErrorFormatter;
import org.selectiverenderer.x3d.url.ResolvedUrlContent;
import org.selectiverenderer.x3d.url.UrlContent;
import org.selectiverenderer.x3d.url.UrlResolver;

/**
 * Reads a file and everything it names in parallel: each file, each geometry and each image is a
 * separate task. A loader serves one load.
 */
final class SceneFileLoader {
  private final X3dReader reader;
  private final Tessellator tessellator;
  private final TaskGroup tasks;
  private final UrlResolver root;
  private final ImageLoader images;
  private final PrototypeLibraryProvider libraries;
  private final ScriptLoader scripts;
  private final ShaderLoader shaders;
  private final SoundLoader sounds;
  private final Map<String, CompletableFuture<Outcome>> files = new ConcurrentHashMap<>();

  SceneFileLoader(
      X3dReader reader,
      Tessellator tessellator,
      TaskGroup tasks,
      UrlResolver root,
      MovieDecoderPool room) {
    this.reader = reader;
    this.tessellator = tessellator;
    this.tasks = tasks;
    this.root = root;
    images = new ImageLoader(root, room);
    libraries = new PrototypeLibraryLoader(reader, root);
    scripts = new ScriptLoader(root);
    shaders = new ShaderLoader(root);
    sounds = new SoundLoader(root);
  }

  /**
   * Reads the stream of the first file on the calling thread. Everything that the file names is
   * complete when all tasks have ended.
   *
   * @param name the file's name, for messages
   * @param key the key of the file, or of the folder to which it belongs
   * @param base the base of its relative urls
   * @param size the size of the stream in bytes if known, else 0
   */
  LoadedFile first(String name, InputStream in, long size, String key, BaseUrl base)
      throws IOException {
    ProblemCollector problems = new ProblemCollector();
    return begin(reader.with(libraries, base).read(name, in, size, problems), key, base, problems);
  }

  /** Reads a text like {@link #first}; its nodes are given to another scene. */
  LoadedFile parts(String name, String text, String key, BaseUrl base) {
    ProblemCollector problems = new ProblemCollector();
    X3dReader own = reader.with(libraries, base).ofParts();
    return begin(own.read(name, text, problems), key, base, problems);
  }

  /** Makes an instance of a prototype, like {@link #first} reads a file. */
  LoadedFile instance(
      String name, PrototypeLibrary library, String prototype, String key, BaseUrl base) {
    ProblemCollector problems = new ProblemCollector();
    X3dReader own = reader.with(libraries, base);
    return begin(own.instance(name, library, prototype, problems), key, base, problems);
  }

  private LoadedFile begin(X3dFile file, String key, BaseUrl base, ProblemCollector problems) {
    LoadedFile content = new LoadedFile(key, base, file);
    content.problems().addAll(problems.list());
    files.put(key, CompletableFuture.completedFuture(new Outcome.Read(content)));
    follow(content);
    return content;
  }

  /**
   * Reads a file in a task; the outcome and everything that the file names are complete when all
   * tasks have ended.
   */
  CompletableFuture<Outcome> file(UrlContent content) {
    return files.computeIfAbsent(
        content.key(),
        wanted -> {
          CompletableFuture<Outcome> outcome = new CompletableFuture<>();
          tasks.start(() -> outcome.complete(read(content)));
          return outcome;
        });
  }

  private Outcome read(UrlContent source) {
    try (InputStream in = source.open()) {
      ProblemCollector problems = new ProblemCollector();
      X3dFile file =
          reader.with(libraries, source.base()).read(source.name(), in, source.size(), problems);
      LoadedFile content = new LoadedFile(source.key(), source.base(), file);
      content.problems().addAll(problems.list());
      Runnable last = begin(content);
      // What has just been read is in the processor's cache, and is smaller once it is a mesh.
      last.run();
      return new Outcome.Read(content);
    } catch (IOException e) {
      return new Outcome.Failed(source.name() + " " + IoErrorFormatter.clause(e));
    }
  }

  private record InlineFile(ParsedNode inline, UrlContent content) {}

  /** Starts tasks that read the files named in a file and make its meshes. */
  void follow(LoadedFile content) {
    tasks.start(begin(content));
  }

  /** Starts these tasks but one, a mesh or nothing, which is left to the caller. */
  private Runnable begin(LoadedFile content) {
    List<InlineFile> inlined = new ArrayList<>();
    List<Runnable> assets = new ArrayList<>();
    List<Runnable> meshes = new ArrayList<>();
    NodeTraversal.visit(
        content.file().allNodes(),
        node -> {
          content.types().add(node.type().name());
          if (node.type().name().equals("Inline") && node.bool("load")) {
            find(node, content, inlined::add);
          } else if (tessellator.handles(node.type())) {
            meshes.add(task(content, problems -> mesh(node, content, problems)));
          } else if (node.type().is("X3DScriptNode")) {
            assets.add(task(content, problems -> program(node, content, problems)));
          } else if (node.type().name().equals("Appearance")) {
            ShaderLoader.noneOfOurs(node)
                .ifPresent(told -> content.problems().addAll(List.of(told)));
          } else if (node.type().is("X3DShaderNode")) {
            ShaderLoader.withoutParts(node)
                .ifPresent(told -> content.problems().addAll(List.of(told)));
          } else if (ShaderLoader.named(node.type())) {
            assets.add(task(content, problems -> shader(node, content, problems)));
          } else if (node.type().name().equals("AudioClip") && node.bool("load")) {
            assets.add(task(content, problems -> sound(node, content, problems)));
          } else if (node.type().name().equals("Sound")
              && node.node("source") instanceof ParsedNode source
              && source.type().name().equals("MovieTexture")
              && source.bool("load")) {
            assets.add(task(content, problems -> soundtrack(source, content, problems)));
          } else if (node.type().is("X3DTextureNode") && ImageLoader.wanted(node)) {
            assets.add(task(content, problems -> image(node, node, content, problems)));
          } else if (BackgroundTextures.names(node.type())) {
            Map<Background.Side, ParsedNode> pictures =
                BackgroundTextures.of(node, reader.catalogue());
            content.pictures().put(node, pictures);
            pictures
                .values()
                .forEach(
                    one ->
                        assets.add(task(content, problems -> image(one, node, content, problems))));
          }
        });
    // The largest first: if it began last, all other threads would wait for it.
    inlined.sort(Comparator.comparingLong((InlineFile found) -> found.content().size()).reversed());
    inlined.forEach(found -> content.inlines().put(found.inline(), file(found.content())));
    assets.forEach(tasks::start);
    Runnable last = meshes.isEmpty() ? () -> {} : meshes.remove(meshes.size() - 1);
    meshes.forEach(tasks::start);
    return last;
  }

  private void find(ParsedNode inline, LoadedFile content, Consumer<InlineFile> found) {
    ResolvedUrlContent choice =
        ResolvedUrlContent.of(inline, root, inline.base(content.base()), "the Inline is left out");
    if (choice instanceof ResolvedUrlContent.Found named) {
      found.accept(new InlineFile(inline, named.content()));
    } else {
      content.problems().addAll(List.of(((ResolvedUrlContent.None) choice).problem()));
    }
  }

  private static Runnable task(LoadedFile content, Consumer<ProblemCollector> work) {
    return () -> {
      ProblemCollector problems = new ProblemCollector();
      work.accept(problems);
      content.problems().addAll(problems.list());
    };
  }

  private void mesh(ParsedNode geometry, LoadedFile content, ProblemCollector problems) {
    Optional<Mesh> mesh = tessellator.tessellate(geometry, problems).map(Mesh::compact);
    content.meshes().put(geometry, mesh);
    mesh.ifPresent(made -> pack(geometry, made));
  }

  /** Packs what a mesh has been made of, save the arrays that the mesh itself keeps. */
  private static void pack(ParsedNode geometry, Mesh mesh) {
    geometry.pack(mesh::keeps);
    for (FieldDefinition field : geometry.type().fields()) {
      if (field.type() == FieldType.SFNode
          && geometry.value(field.index()) instanceof ParsedNode property
          && property.type().is("X3DGeometricPropertyNode")) {
        property.pack(mesh::keeps);
      }
    }
  }

  private void program(ParsedNode script, LoadedFile content, ProblemCollector problems) {
    scripts
        .read(script, script.base(content.base()), problems)
        .ifPresent(program -> content.programs().put(script, program));
  }

  private void shader(ParsedNode part, LoadedFile content, ProblemCollector problems) {
    content.shaders().put(part, shaders.read(part, part.base(content.base()), problems));
  }

  private void sound(ParsedNode clip, LoadedFile content, ProblemCollector problems) {
    sounds
        .read(clip, clip.base(content.base()), problems)
        .ifPresent(recording -> content.sounds().put(clip, recording));
  }

  private void soundtrack(ParsedNode movie, LoadedFile content, ProblemCollector problems) {
    sounds
        .soundtrack(movie, movie.base(content.base()), problems)
        .ifPresent(recording -> content.sounds().put(movie, recording));
  }

  /**
   * @param owner the node that names the image: the texture itself, or a Background
   */
  private void image(
      ParsedNode texture, ParsedNode owner, LoadedFile content, ProblemCollector problems) {
    content.images().put(texture, images.read(texture, owner.base(content.base()), problems));
  }

  /** Loads the programs of Scripts. */
  private static final class ScriptLoader {
    private final UrlResolver root;

    ScriptLoader(UrlResolver root) {
      this.root = root;
    }

    /**
     * Loads the program of a Script; empty, with a message, if it has no usable one.
     *
     * @param base the base of the Script's relative urls
     */
    Optional<ScriptProgram> read(ParsedNode script, BaseUrl base, ProblemCollector problems) {
      ScriptProgramSelection choice = ScriptProgramSelection.of(script, root, base);
      if (choice instanceof ScriptProgramSelection.Text text) {
        return Optional.of(text.program());
      }
      if (choice instanceof ScriptProgramSelection.File file) {
        return fromFile(script, file.content(), problems);
      }
      problems.add(((ScriptProgramSelection.None) choice).problem());
      return Optional.empty();
    }

    private static Optional<ScriptProgram> fromFile(
        ParsedNode script, UrlContent file, ProblemCollector problems) {
      try {
        return Optional.of(ScriptProgram.read(file));
      } catch (IOException e) {
        problems.error(
            script.location(),
            "%s %s; the Script does nothing".formatted(file.name(), IoErrorFormatter.clause(e)));
        return Optional.empty();
      }
    }
  }
}
