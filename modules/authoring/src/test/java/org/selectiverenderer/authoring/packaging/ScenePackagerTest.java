package org.selectiverenderer.authoring.packaging;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.zip.ZipFile;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;
import org.selectiverenderer.x3d.url.HttpFetcher;

/** A scene leaves with all that it names, and finds it again where it arrives. */
class ScenePackagerTest {
  @TempDir Path folder;
  private Path scenes;

  @BeforeEach
  void files() throws IOException {
    scenes = Files.createDirectories(folder.resolve("project/scenes"));
    write("project/scenes/textures/wood.png", "wood");
    write("project/scenes/sky.png", "sky");
    write("project/scenes/say.js", "function initialize() {}");
    write("project/scenes/hum.wav", "hum");
    write(
        "project/inlineNodes/desk.x3d",
        "<X3D version='4.0'><Scene><Inline url='\"lamp.wrl\"'/>\n"
            + "<Shape><Appearance><ImageTexture url='\"textures/top.png\"'/></Appearance><Box/>"
            + "</Shape></Scene></X3D>");
    write("project/inlineNodes/textures/top.png", "top");
    write(
        "project/inlineNodes/lamp.wrl",
        "#VRML V2.0 utf8\nShape { appearance Appearance { texture ImageTexture {"
            + " url [\"../../shared/glow.png\", \"http://example.org/glow.png\"] } }"
            + " geometry Box {} }\n");
    write("shared/glow.png", "glow");
    write(
        "shared/protos.x3d",
        "<X3D version='4.0'><Scene><ProtoDeclare name='Cup'><ProtoBody>"
            + "<Shape><Appearance><ImageTexture url='\"cup.png\"'/></Appearance><Box/></Shape>"
            + "</ProtoBody></ProtoDeclare></Scene></X3D>");
    write("shared/cup.png", "cup");
    write("secret/key.txt", "key");
  }

  private Path write(String name, String text) throws IOException {
    Path file = folder.resolve(name);
    Files.createDirectories(file.getParent());
    return Files.writeString(file, text);
  }

  private ScenePackage collect(String nodes, Path... allowed) throws IOException {
    String text = "<X3D version='4.0'>\n<Scene>\n" + nodes + "\n</Scene>\n</X3D>\n";
    Path scene = Files.writeString(scenes.resolve("room.x3d"), text);
    return new ScenePackager(
            NodeCatalogue.load(),
            scenes,
            new ContentAccessPolicy(List.of(allowed), HttpFetcher.none()),
            PackageLayout.around(scenes.toRealPath()),
            () -> false)
        .collect(
            scene,
            SceneDocument.of(scene.toString(), text.getBytes()).snapshot(),
            Path.of("room.x3d"));
  }

  private static List<String> places(ScenePackage packed) {
    return packed.files().stream().map(f -> f.target().toString().replace('\\', '/')).toList();
  }

  @Test
  void picturesOfOtherLevelsOfATextureAreTakenToo() throws IOException {
    write("shared/wood_25.png", "small");
    String string = "<MetadataString name='%s' value='%s' containerField='value'/>";
    ScenePackage packed =
        collect(
            "<ImageTexture DEF='Wood' url='\"textures/wood.png\"'/><Switch><MetadataSet"
                + " containerField='metadata'><MetadataSet name='fieldQualities'"
                + " containerField='metadata'><MetadataSet containerField='value'>"
                + string.formatted("quality", "\"textures\"")
                + string.formatted("field", "\"Wood.url\"")
                + "<MetadataSet containerField='value'>"
                + string.formatted("value", "\"../../shared/wood_25.png\"")
                + "</MetadataSet></MetadataSet></MetadataSet></MetadataSet></Switch>"
                + string.formatted("value", "\"../../secret/key.txt\""),
            folder.resolve("shared"),
            folder.resolve("secret"));
    assertThat(places(packed)).anyMatch(place -> place.endsWith("wood_25.png"));
    assertThat(places(packed)).noneMatch(place -> place.endsWith("key.txt"));
    assertThat(new String(packed.scene().changed().orElseThrow()))
        .as("the level names it where it is now")
        .contains("wood_25.png")
        .doesNotContain("../shared/wood_25.png");
  }

  @Test
  void allThatASceneNamesIsTakenAndFoundAgain() throws IOException {
    ScenePackage packed =
        collect(
            """
            <Background frontUrl='"sky.png"' backUrl='"http://example.org/sky.png" "sky.png"'/>
            <TextureBackground><ImageTexture containerField='topTexture' url='"textures/wood.png"'/>
            </TextureBackground>
            <Script url='"ecmascript:" "say.js"'/>
            <Sound><AudioClip url='"hum.wav"'/></Sound>
            <ExternProtoDeclare name='Cup' url='"../../shared/protos.x3d#Cup"'/>
            <Inline DEF='Desk' url='"../inlineNodes/desk.x3d"'/>""",
            folder.resolve("shared"));
    assertThat(packed.left()).isEmpty();
    assertThat(places(packed))
        .containsExactlyInAnyOrder(
            "sky.png",
            "textures/wood.png",
            "say.js",
            "hum.wav",
            "shared/protos.x3d",
            "shared/cup.png",
            "inlineNodes/desk.x3d",
            "inlineNodes/textures/top.png",
            "inlineNodes/lamp.wrl",
            "shared/glow.png");
    Path target = folder.resolve("target");
    List<PackagedFile> all = new ArrayList<>(packed.files());
    all.add(packed.scene());
    PackageWriter.intoFolder(all, target, done -> {});
    assertThat(target.resolve("room.x3d"))
        .content()
        .contains("url='\"shared/protos.x3d#Cup\"'")
        .contains("<Inline DEF='Desk' url='\"inlineNodes/desk.x3d\"'/>")
        .contains("backUrl='\"http://example.org/sky.png\" \"sky.png\"'");
    assertThat(target.resolve("inlineNodes/lamp.wrl"))
        .content()
        .contains("[\"../shared/glow.png\", \"http://example.org/glow.png\"]");
    assertThat(target.resolve("inlineNodes/desk.x3d"))
        .hasSameBinaryContentAs(folder.resolve("project/inlineNodes/desk.x3d"));
    assertThat(target.resolve("shared/cup.png")).hasContent("cup");
    ScenePackage again = repack(target);
    assertThat(again.left()).isEmpty();
    assertThat(again.files()).hasSameSizeAs(packed.files());
  }

  private static ScenePackage repack(Path target) throws IOException {
    Path scene = target.resolve("room.x3d");
    return new ScenePackager(
            NodeCatalogue.load(),
            target,
            ContentAccessPolicy.none(),
            PackageLayout.around(target.toRealPath()),
            () -> false)
        .collect(
            scene,
            SceneDocument.of(scene.toString(), Files.readAllBytes(scene)).snapshot(),
            Path.of("room.x3d"));
  }

  @Test
  void whatASceneMayNotReadAndOtherHostsAreListedAndNotTaken() throws IOException {
    ScenePackage packed =
        collect(
            """
            <Inline url='"../../secret/key.txt"'/>
            <Inline url='"http://example.org/a.x3d"'/>
            <Inline url='"gone.x3d"'/>""");
    assertThat(packed.files()).isEmpty();
    assertThat(packed.left())
        .extracting(ScenePackage.LeftOut::url)
        .containsExactly("../../secret/key.txt", "http://example.org/a.x3d", "gone.x3d");
    assertThat(packed.edits()).isEmpty();
  }

  @Test
  void filesThatNameEachOtherAreTakenOnce() throws IOException {
    write("project/scenes/a.x3d", "<X3D><Scene><Inline url='\"b.x3d\"'/></Scene></X3D>");
    write(
        "project/scenes/b.x3d", "<X3D><Scene><Inline url='\"a.x3d\" \"room.x3d\"'/></Scene></X3D>");
    assertThat(places(collect("<Inline url='\"a.x3d\"'/>"))).containsExactly("a.x3d", "b.x3d");
  }

  @Test
  void twoFilesNeverGetTheSamePlace() throws IOException {
    write("project/scenes/shared/glow.png", "other");
    ScenePackage packed =
        collect(
            "<ImageTexture url='\"shared/glow.png\"'/><ImageTexture url='\"../../shared/glow.png\"'/>",
            folder.resolve("shared"));
    assertThat(places(packed)).containsExactly("shared/glow.png", "shared/glow-2.png");
    assertThat(new String(packed.scene().changed().orElseThrow())).contains("shared/glow-2.png");
  }

  @Test
  void aModelTakesItsBuffersAndPicturesAlong() throws IOException {
    write(
        "project/scenes/models/box.gltf",
        """
        {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
         "nodes": [{"mesh": 0}],
         "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "material": 0}]}],
         "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}],
         "textures": [{"source": 0}], "images": [{"uri": "skin.png"}],
         "buffers": [{"uri": "box.bin", "byteLength": 36}],
         "bufferViews": [{"buffer": 0, "byteLength": 36}],
         "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                        "min": [0, 0, 0], "max": [0, 0, 0]}]}
        """);
    Files.write(scenes.resolve("models/box.bin"), new byte[36]);
    write("project/scenes/models/skin.png", "skin");
    assertThat(places(collect("<Inline url='\"models/box.gltf\"'/>")))
        .containsExactlyInAnyOrder("models/box.gltf", "models/box.bin", "models/skin.png");
  }

  @Test
  void filesOfTheSameNameAndOtherContentAreConflictsAndNothingIsWrittenOutside()
      throws IOException {
    ScenePackage packed = collect("<ImageTexture url='\"textures/wood.png\"'/>");
    Path target = Files.createDirectories(folder.resolve("target"));
    assertThat(PackageWriter.conflicts(packed.files(), target)).isEmpty();
    Files.createDirectories(target.resolve("textures"));
    Files.writeString(target.resolve("textures/wood.png"), "mine");
    assertThat(PackageWriter.conflicts(packed.files(), target))
        .containsExactly(target.resolve("textures/wood.png"));
    Files.writeString(target.resolve("textures/wood.png"), "wood");
    assertThat(PackageWriter.conflicts(packed.files(), target)).isEmpty();

    Path linked = Files.createDirectories(folder.resolve("linked"));
    Files.createSymbolicLink(linked.resolve("textures"), folder.resolve("secret"));
    assertThatThrownBy(() -> PackageWriter.intoFolder(packed.files(), linked, done -> {}))
        .isInstanceOf(IOException.class)
        .hasMessageContaining("lies outside");
    assertThat(folder.resolve("secret/wood.png")).doesNotExist();
  }

  @Test
  void aFileThatIsStillToBeCopiedIsNotReplaced() throws IOException {
    write("project/textures/wood.png", "other wood");
    ScenePackage packed =
        collect(
            "<Shape><Appearance><ImageTexture url='\"textures/wood.png\"'/></Appearance></Shape>"
                + "<Shape><Appearance><ImageTexture url='\"../textures/wood.png\"'/></Appearance>"
                + "</Shape>",
            folder.resolve("project"));
    Path project = folder.resolve("project");

    assertThatThrownBy(() -> PackageWriter.intoFolder(packed.files(), project, done -> {}))
        .hasMessageContaining("is a file of the scene and would be replaced");
    assertThat(project.resolve("textures/wood.png")).hasContent("other wood");
  }

  @Test
  void anArchiveHoldsTheSameFiles() throws IOException {
    ScenePackage packed = collect("<ImageTexture url='\"textures/wood.png\"'/>");
    List<PackagedFile> all = List.of(packed.scene(), packed.files().get(0));
    Path zip = folder.resolve("room.zip");
    PackageWriter.intoZip(all, zip, done -> {});
    try (ZipFile archive = new ZipFile(zip.toFile())) {
      assertThat(archive.stream().map(Object::toString).toList())
          .containsExactly("room.x3d", "textures/wood.png");
    }
    try (var left = Files.list(folder)) {
      assertThat(left.map(p -> p.getFileName().toString())).noneMatch(n -> n.contains(".part"));
    }
  }

  private String packed(String name, String text) throws IOException {
    write("project/other/" + name, text);
    write("project/tex/wood.png", "wood");
    write("project/scenes/tex/wood.png", "other wood");
    ScenePackage packed =
        collect(
            "<ImageTexture url='\"tex/wood.png\"'/><Inline url='\"../other/%s\"'/>".formatted(name),
            folder.resolve("project"));
    assertThat(packed.left()).isEmpty();
    return packed.files().stream()
        .filter(file -> file.target().endsWith(name))
        .findFirst()
        .map(file -> new String(file.changed().orElseThrow()))
        .orElseThrow();
  }

  @Test
  void onlyTheUrlItselfIsChangedInVrml() throws IOException {
    String url = "\"../tex/wood.png\"";
    String vrml =
        """
        #VRML V2.0 utf8
        # URL
        DEF url Group { children [
          Shape { appearance DEF A Appearance {
            texture DEF T ImageTexture { # url URL
              repeatS FALSE metadata MetadataString { name URL value [ URL ] }
              url [ # URL
                "http://example.org/x.png", URL ] } }
            geometry Text { string [ "url" URL "url [" URL ] } }
        ] }
        WorldInfo { title URL }
        PROTO P [ field MFString skinUrl [ URL ] ] { Group { } }
        P { skinUrl URL }
        """
            .replace("URL", url);
    String now = packed("house.wrl", vrml);
    assertThat(now)
        .isEqualTo(
            vrml.replace(
                    "\"http://example.org/x.png\", " + url, "\"http://example.org/x.png\", NEW")
                .replace("skinUrl [ " + url, "skinUrl [ NEW")
                .replace("skinUrl " + url, "skinUrl NEW")
                .replace("NEW", "\"../tex/wood-2.png\""));
  }

  @Test
  void onlyTheUrlItselfIsChangedInJson() throws IOException {
    String json =
        """
        {"X3D": {"@version": "4.0", "Scene": {"-children": [
          {"WorldInfo": {"@title": "../scenes/sky.png"}},
          {"Shape": {"-appearance": {"Appearance": {"-texture": {"ImageTexture": {
            "@DEF": "../scenes/sky.png",
            "-metadata": {"MetadataString": {"@value": ["../scenes/sky.png"]}},
            "@url": ["http:\\/\\/example.org\\/x.png", "..\\/scenes\\/sky.png"]}}}},
            "-geometry": {"Text": {"@string": ["@url", "../scenes/sky.png"]}}}}
        ]}}}
        """;
    write("project/scenes/sky.png", "sky");
    String now = packed("house.json", json);
    assertThat(now).isEqualTo(json.replace("..\\/scenes\\/sky.png", "../sky.png"));
  }

  @Test
  void namesThatWindowsForbidsBecomeOthers() throws IOException {
    write("project/scenes/con.png", "1");
    write("project/scenes/a:b?.png", "2");
    write("project/scenes/dir./x.png", "3");
    write("project/scenes/" + "ü".repeat(125) + ".png", "4");
    write("project/scenes/50% of #1.png", "5");
    ScenePackage packed =
        collect(
            "<ImageTexture url='\"con.png\"'/><ImageTexture url='\"./a:b%3F.png\"'/>"
                + "<ImageTexture url='\"dir./x.png\"'/>"
                + "<ImageTexture url='\""
                + "ü".repeat(125)
                + ".png\"'/>"
                + "<ImageTexture url='\"50%25 of %231.png\"'/>");
    assertThat(packed.left()).isEmpty();
    assertThat(places(packed))
        .containsExactly(
            "_con.png", "a_b_.png", "dir_/x.png", "ü".repeat(125) + ".png", "50% of #1.png");
    Path target = folder.resolve("windows");
    List<PackagedFile> all = new ArrayList<>(packed.files());
    all.add(packed.scene());
    PackageWriter.intoFolder(all, target, done -> {});
    ScenePackage again = repack(target);
    assertThat(again.left()).isEmpty();
    assertThat(again.files()).hasSize(5);
    assertThat(again.edits()).isEmpty();
  }

  /** Returns all files below a folder with their contents. */
  private static List<String> tree(Path folder) throws IOException {
    try (var all = Files.walk(folder)) {
      return all.map(
              path -> {
                try {
                  return folder.relativize(path)
                      + (Files.isRegularFile(path) ? "=" + Files.readString(path) : "");
                } catch (IOException e) {
                  throw new java.io.UncheckedIOException(e);
                }
              })
          .sorted()
          .toList();
    }
  }

  @Test
  void aCancelledOrFailedPackageLeavesNothingBehindAndRestoresWhatItReplaced() throws IOException {
    ScenePackage packed =
        collect("<ImageTexture url='\"textures/wood.png\"'/><ImageTexture url='\"sky.png\"'/>");
    Path target = Files.createDirectories(folder.resolve("target"));
    Files.writeString(target.resolve("sky.png"), "mine");
    List<String> before = tree(target);
    assertThatThrownBy(
            () ->
                PackageWriter.intoFolder(
                    packed.files(),
                    target,
                    done -> {
                      if (done > 0.5) {
                        throw new java.util.concurrent.CancellationException();
                      }
                    }))
        .isInstanceOf(java.util.concurrent.CancellationException.class);
    assertThat(tree(target)).isEqualTo(before);

    Path fresh = folder.resolve("deep/er");
    assertThatThrownBy(
            () ->
                PackageWriter.intoFolder(
                    packed.files(),
                    fresh,
                    done -> {
                      throw new java.util.concurrent.CancellationException();
                    }))
        .isInstanceOf(java.util.concurrent.CancellationException.class);
    assertThat(folder.resolve("deep")).doesNotExist();

    // The last file finds a folder in its place when the others are written.
    Path full = Files.createDirectories(folder.resolve("full"));
    Files.createDirectories(full.resolve("sky.png/in"));
    List<String> was = tree(full);
    assertThatThrownBy(() -> PackageWriter.intoFolder(packed.files(), full, done -> {}))
        .isInstanceOf(IOException.class)
        .hasMessageContaining("sky.png");
    assertThat(tree(full)).isEqualTo(was);

    Path zip = folder.resolve("room.zip");
    assertThatThrownBy(
            () ->
                PackageWriter.intoZip(
                    packed.files(),
                    zip,
                    done -> {
                      throw new java.util.concurrent.CancellationException();
                    }))
        .isInstanceOf(java.util.concurrent.CancellationException.class);
    assertThat(zip).doesNotExist();

    WrittenFiles written = PackageWriter.intoFolder(packed.files(), target, done -> {});
    assertThat(target.resolve("sky.png")).hasContent("sky");
    Files.writeString(target.resolve("textures/other.txt"), "another program's");
    written.withdraw();
    assertThat(tree(target))
        .containsExactly("", "sky.png=mine", "textures", "textures/other.txt=another program's");
  }

  @Test
  void anArchiveThatIsWithdrawnIsReplacedByTheFormerOne() throws IOException {
    ScenePackage packed = collect("<ImageTexture url='\"sky.png\"'/>");
    Path target = Files.createDirectories(folder.resolve("archives"));
    Path zip = Files.writeString(target.resolve("room.zip"), "former");
    PackageWriter.intoZip(packed.files(), zip, done -> {}).withdraw();
    assertThat(tree(target)).containsExactly("", "room.zip=former");
    PackageWriter.intoZip(packed.files(), zip, done -> {}).keep();
    assertThat(Files.size(zip)).isGreaterThan(50);
    try (var all = Files.list(target)) {
      assertThat(all).containsExactly(zip);
    }
  }

  @Test
  void aFileOfAnotherProgramSinceIsNeverRemovedAndTheFormerOneIsNamed() throws IOException {
    ScenePackage packed =
        collect("<ImageTexture url='\"textures/wood.png\"'/><ImageTexture url='\"sky.png\"'/>");
    Path target = Files.createDirectories(folder.resolve("target"));
    Files.createDirectories(target.resolve("textures"));
    Files.writeString(target.resolve("sky.png"), "mine");
    Files.writeString(target.resolve("textures/wood.png"), "my wood");
    WrittenFiles written = PackageWriter.intoFolder(packed.files(), target, done -> {});
    Files.writeString(target.resolve("sky.png"), "another program's");
    Path kept = target.resolve(".package.part/replaced/sky.png");
    assertThatThrownBy(written::withdraw)
        .isInstanceOf(IOException.class)
        .hasMessageContaining(target.resolve("sky.png").toString())
        .hasMessageContaining("it is kept as " + kept);
    assertThat(kept).hasContent("mine");
    assertThat(target.resolve("sky.png")).hasContent("another program's");
    assertThat(target.resolve("textures/wood.png")).hasContent("my wood");
  }

  @Test
  void aFileThatAppearsDuringTheExchangeStaysAndAllElseIsRestored() throws IOException {
    Path target = Files.createDirectories(folder.resolve("target"));
    Path sky = Files.writeString(target.resolve("sky.png"), "mine");
    WrittenFiles log = new WrittenFiles();
    Path stage = log.stage(target);
    Path wood = Files.writeString(target.resolve("wood.png"), "my wood");
    log.exchange(
        Files.writeString(stage.resolve("new-2"), "new wood"),
        wood,
        Optional.of(WrittenFiles.former(stage, Path.of("wood.png"))));
    // Moved away, but nothing is put there; meanwhile another program writes the place.
    Path missing = stage.resolve("missing");
    Optional<Path> former = Optional.of(WrittenFiles.former(stage, Path.of("sky.png")));
    assertThatThrownBy(() -> log.exchange(missing, sky, former)).isInstanceOf(IOException.class);
    Files.writeString(sky, "another program's");
    assertThatThrownBy(log::withdraw).hasMessageContaining("it is kept as " + former.get());
    assertThat(former.get()).hasContent("mine");
    assertThat(sky).hasContent("another program's");
    assertThat(wood).hasContent("my wood");
  }

  @Test
  void anArchiveInAFolderThatIsMissingSaysWhatIsWrong() throws IOException {
    ScenePackage packed = collect("<ImageTexture url='\"sky.png\"'/>");
    Path zip = folder.resolve("missing/room.zip");
    assertThatThrownBy(() -> PackageWriter.intoZip(packed.files(), zip, done -> {}))
        .hasMessageStartingWith(zip.getParent().toString())
        .hasMessageEndingWith(": does not exist");
  }

  @Test
  void aFileInPlaceOfTheFolderIsNamed() throws IOException {
    ScenePackage packed = collect("<ImageTexture url='\"sky.png\"'/>");
    Path file = Files.writeString(folder.resolve("file"), "mine");
    assertThatThrownBy(() -> PackageWriter.intoFolder(packed.files(), file, done -> {}))
        .hasMessage(file + ": is a file, not a folder");
    assertThat(file).hasContent("mine");
  }
}
