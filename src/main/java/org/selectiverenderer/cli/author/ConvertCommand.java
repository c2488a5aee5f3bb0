package org.selectiverenderer.cli.author;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.selectiverenderer.authoring.MFStringParser;
import org.selectiverenderer.authoring.file.BrokenRelativeUrls;
import org.selectiverenderer.authoring.importing.EmbeddedPictures;
import org.selectiverenderer.base.files.FileTransaction;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.browser.loading.ImageTranscoder;
import org.selectiverenderer.command.CliCommand;
import org.selectiverenderer.command.option.AccessOptions;
import org.selectiverenderer.command.output.CommandException;
import org.selectiverenderer.command.output.CommandFileCheck;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.command.output.ExitStatus;
import org.selectiverenderer.command.output.OutputFile;
import org.selectiverenderer.command.output.UndeletedFilesWarning;
import org.selectiverenderer.models.gltf.write.GlbWriter;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.model.ModelFormat;
import org.selectiverenderer.x3d.read.PrototypeLibraryLoader;
import org.selectiverenderer.x3d.read.X3dFile;
import org.selectiverenderer.x3d.read.X3dReader;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.DocumentError;
import org.selectiverenderer.x3d.source.Gzip;
import org.selectiverenderer.x3d.source.XmlDocument;
import org.selectiverenderer.x3d.url.BaseUrl;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;
import org.selectiverenderer.x3d.url.UrlResolver;
import org.selectiverenderer.x3d.write.SceneFormat;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

@Command(
    name = "convert",
    description = {
      "Writes a scene, or a model such as glTF, in another encoding: X3D XML, ClassicVRML or X3D JSON;"
          + " or as glTF 2.0.",
      "What the scene is written in is seen from its content. What OUT is written in follows from its "
          + "ending; .x3dz, .x3dvz, .x3djz and .gz are compressed.",
      "A .glb or .gltf file has what is inlined, and tells what glTF cannot hold."
    },
    footer = {
      "  ./selective-renderer convert docs/examples/house.wrl house.x3d",
      "  ./selective-renderer convert scenes/trashcan.x3d scenes/trashcan.x3dv",
      "  ./selective-renderer convert scenes/trashcan.x3d trashcan.glb",
      "  ./selective-renderer convert inlineNodes/carpet.x3d carpet.glb",
      "  ./selective-renderer convert carpet.glb carpet.x3d --embed"
    })
public final class ConvertCommand extends CliCommand {
  /** The number of bytes by which a model is recognised. */
  private static final int HEAD = 4096;

  @Parameters(paramLabel = "IN", index = "0", description = "scene to read")
  private Path scene = Path.of("");

  @Parameters(
      paramLabel = "OUT",
      index = "1",
      description =
          "file to write: .x3d, .x3dz, .x3dv, .x3dvz, .x3dj, .x3djz, .json, .glb or .gltf")
  private Path output = Path.of("");

  @Option(
      names = "--embed",
      description = "keeps the pictures inside of a model in OUT, instead of in files beside it")
  private boolean embed;

  @Mixin private AccessOptions access = new AccessOptions();

  public ConvertCommand(Console console) {
    super(console);
  }

  @Override
  public ExitStatus run() throws IOException {
    OutputFile.check("OUT", output);
    Optional<GlbWriter.Form> model = GlbWriter.Form.of(output.toString());
    if (SceneFormat.of(output.toString()).isEmpty()
        && model.isEmpty()
        && !FileTransaction.sink(output)) {
      throw CommandException.usage("OUT " + output + ": " + notWritten(output.toString()));
    }
    if (Files.isDirectory(scene)) {
      throw CommandException.environment("IN " + scene + ": is a folder, not a scene");
    }
    SceneFormat format = SceneFormat.of(output.toString()).orElse(SceneFormat.XML);
    if (Files.exists(output) && Files.exists(scene) && Files.isSameFile(output, scene)) {
      throw CommandException.environment(
          "OUT " + output + ": is the scene itself, which would be lost; name another file");
    }
    NodeCatalogue catalogue = NodeCatalogue.load();
    ContentAccessPolicy allowed = access.access();
    X3dReader reader = reader(catalogue, allowed);
    XmlDocument document;
    try (InputStream in = Files.newInputStream(scene)) {
      document = reader.document(scene.toString(), in, Files.size(scene));
    }
    ProblemCollector problems = new ProblemCollector(console()::problem);
    for (DocumentError fault : document.faults()) {
      if (fault.kind() == DocumentError.Kind.ENCODING || fault.kind() == DocumentError.Kind.MODEL) {
        problems.warning(fault.location(), fault.message());
      } else {
        problems.error(fault.location(), fault.message() + "; nothing is written");
      }
    }
    if (document.broken()) {
      return ExitStatus.PROBLEMS;
    }
    if (document.rootFault().isPresent()) {
      problems.error(
          document.root().orElseThrow().location(),
          document.rootFault().get() + "; nothing is written");
      return ExitStatus.PROBLEMS;
    }
    keepInlined(document);
    if (model.isPresent()) {
      X3dFile file = reader.scene(document, problems);
      return writeModel(
          file, new GlbWriter(catalogue, allowed, ImageTranscoder::png), model.get(), problems);
    }
    String text = format.text(document, catalogue, problems);
    FileTransaction writing = new FileTransaction();
    if (!embed && isModel() && !FileTransaction.sink(output)) {
      EmbeddedPictures pictures = new EmbeddedPictures(output);
      text = pictures.takenFrom(text);
      pictures.contents().forEach(writing::addNew);
    }
    byte[] plain = text.getBytes(StandardCharsets.UTF_8);
    writing.add(output, SceneFormat.packed(output.toString()) ? Gzip.packed(plain) : plain);
    UndeletedFilesWarning.tell(writing.commit(), console());
    List<String> left =
        BrokenRelativeUrls.in(
            document.elements(),
            scene.toAbsolutePath().getParent(),
            output.toAbsolutePath().getParent());
    MissingFilesWarning.tell(left, output, console());
    return status(problems);
  }

  /** Returns the status: what OUT cannot hold is a warning, and no fault of the scene. */
  private static ExitStatus status(ProblemCollector problems) {
    return problems.anyError() ? ExitStatus.PROBLEMS : ExitStatus.DONE;
  }

  /** Returns why a file of this name is not written, and what is. */
  private static String notWritten(String name) {
    return name.toLowerCase(Locale.ROOT).matches(".*\\.(wrl|wrz|wrl\\.gz)")
        ? "VRML97 and VRML 1.0 are read and not written; use .x3dv for ClassicVRML, which VRML97 has"
            + " become, or .x3d for X3D XML"
        : "its file name extension names no encoding; use .x3d for X3D XML, .x3dv for"
            + " ClassicVRML, .x3dj for X3D JSON or .glb for glTF";
  }

  private boolean isModel() throws IOException {
    try (InputStream in = Files.newInputStream(scene)) {
      byte[] head = in.readNBytes(HEAD);
      return ModelFormat.of(scene.toString(), head, head.length).isPresent();
    }
  }

  /** Returns the reader of the scene, which as a model may have files in its folder. */
  private X3dReader reader(NodeCatalogue catalogue, ContentAccessPolicy allowed) {
    X3dReader reader = new X3dReader(catalogue);
    return reader.with(
        new PrototypeLibraryLoader(reader, new UrlResolver(folder(), allowed)),
        BaseUrl.folder(folder()));
  }

  /** Returns the folder of the scene. */
  private Path folder() {
    Path parent = scene.toAbsolutePath().getParent();
    return parent == null ? scene.toAbsolutePath() : parent;
  }

  private ExitStatus writeModel(
      X3dFile file, GlbWriter writer, GlbWriter.Form form, ProblemCollector problems)
      throws IOException {
    Optional<byte[]> bytes = writer.bytes(file, folder(), form, problems);
    if (bytes.isPresent()) {
      FileTransaction writing = new FileTransaction();
      writing.add(output, bytes.get());
      UndeletedFilesWarning.tell(writing.commit(), console());
    }
    return status(problems);
  }

  /** Rejects an output that would overwrite a file to which the scene refers. */
  private void keepInlined(XmlDocument document) throws IOException {
    ContentAccessPolicy named = ContentAccessPolicy.none();
    Path folder = scene.toAbsolutePath().getParent();
    if (folder != null) {
      UrlResolver root = new UrlResolver(folder, named);
      for (DocumentElement element : document.elements()) {
        for (String url : MFStringParser.strings(element.text("url").orElse(""))) {
          root.note(url, BaseUrl.folder(folder));
        }
      }
    }
    new CommandFileCheck().writes("OUT", output).check(named.named());
  }
}
