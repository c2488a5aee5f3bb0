package org.selectiverenderer.cli.author;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.cli.CommandTestCase;

class EnrichCommandTest {
  private static final Pattern HEAD = Pattern.compile("(?s)<head>.*?</head>");
  private static final String PLAIN = "scenes/apartment-plain.x3d";
  private static final String RATINGS = "scenes/apartment-ratings.csv";
  private static final String SCENE =
      """
      <X3D><Scene>
        <Switch DEF='Switch_Cup'>
          <Shape/>
        </Switch>
      </Scene></X3D>
      """;

  @TempDir Path folder;

  private String out = "";
  private String err = "";

  private int run(String... args) {
    CommandTestCase command = new CommandTestCase();
    int status = command.execute(args);
    out = command.printed();
    err = command.messages();
    return status;
  }

  @Test
  void theRatingsMakeTheCommittedApartmentByteForByte() throws IOException {
    Path enriched = folder.resolve("apartment.x3d");
    assertThat(run("enrich", PLAIN, "--ratings", RATINGS, "--output", enriched.toString()))
        .as(err)
        .isZero();
    // Title and description tell the two scenes apart.
    assertThat(HEAD.matcher(Files.readString(enriched)).replaceFirst(""))
        .isEqualTo(
            HEAD.matcher(Files.readString(Path.of("scenes/apartment.x3d"))).replaceFirst(""));
  }

  @Test
  void theApartmentOfTheRatingsBehavesAsTheCommittedOne() throws IOException {
    Path scenes = Files.createDirectory(folder.resolve("scenes"));
    copy(Path.of("inlineNodes"));
    copy(Path.of("inlineNodes", "textures"));
    Path enriched = scenes.resolve("apartment.x3d");
    run("enrich", PLAIN, "--ratings", RATINGS, "--output", enriched.toString());
    String path = "scenes/paths/apartment-tour.csv";
    assertThat(run("simulate", enriched.toString(), "--path", path, "--format", "json")).isZero();
    String ours = out;
    run("simulate", "scenes/apartment.x3d", "--path", path, "--format", "json");
    assertThat(ours).isEqualTo(out).contains("\"event\":\"switch\"");
  }

  /** Copies the files of a folder of the project to the same place below the test's own. */
  private void copy(Path from) throws IOException {
    Path to = Files.createDirectories(folder.resolve(from));
    try (var files = Files.list(from)) {
      for (Path file : files.filter(Files::isRegularFile).toList()) {
        Files.copy(file, to.resolve(file.getFileName()));
      }
    }
  }

  private Path scene() throws IOException {
    return Files.writeString(folder.resolve("cup.x3d"), SCENE);
  }

  private Path table(String rows) throws IOException {
    return Files.writeString(folder.resolve("m.csv"), "node,choice,field,value\n" + rows);
  }

  @Test
  void aDryRunPrintsTheDifferenceAndWritesNothing() throws IOException {
    Path scene = scene();
    Path table = table("Switch_Cup,0,schemaBelonginess,Desk\n");
    assertThat(run("enrich", scene.toString(), "--apply", table.toString(), "--dry-run")).isZero();
    assertThat(out)
        .isEqualTo(
            """
            --- %1$s
            +++ %1$s
            @@ -1,5 +1,10 @@
             <X3D><Scene>
               <Switch DEF='Switch_Cup'>
            +    <MetadataSet containerField='metadata' DEF='MetadataSet_CupDefinition' name='Cup'>
            +      <MetadataSet containerField='value' DEF='MetadataSetCup_Part1Definition' name='Cup_v1'>
            +        <MetadataString containerField='value' DEF='schemaBelonginessDefinitionCup_Part1' name='schemaBelonginess' value='"Desk"'/>
            +      </MetadataSet>
            +    </MetadataSet>
                 <Shape/>
               </Switch>
             </Scene></X3D>
            """
                .formatted(scene));
    assertThat(scene).hasContent(SCENE);
  }

  @Test
  void withoutAnOutputTheSceneIsChangedAndKeptBeside() throws IOException {
    Path scene = scene();
    Path table = table("Switch_Cup,0,schemaBelonginess,Desk\n");
    assertThat(run("enrich", scene.toString(), "--apply", table.toString())).isZero();
    assertThat(err).isEqualTo(scene + ": enriched\n");
    assertThat(Files.readString(scene)).contains("\"Desk\"");
    assertThat(folder.resolve("cup.x3d.bak")).hasContent(SCENE);
    run("enrich", scene.toString(), "--apply", table.toString());
    assertThat(err).isEqualTo(scene + ": has all of this metadata already; nothing is written\n");
  }

  @Test
  void aFaultyTableOrSceneChangesNothing() throws IOException {
    Path scene = scene();
    assertThat(run("enrich", scene.toString(), "--apply", table("Cap,0,x,y\n").toString()))
        .isEqualTo(1);
    assertThat(scene).hasContent(SCENE);
    Path broken = Files.writeString(folder.resolve("broken.x3d"), "<X3D>\n<Scene></X3D>");
    assertThat(run("enrich", broken.toString(), "--apply", table("").toString())).isEqualTo(1);
    assertThat(err).startsWith(broken + ":2:").endsWith("; nothing has been changed\n");
  }

  @Test
  void ratingsOfWhatIsNotInTheSceneAreTold() throws IOException {
    Path ratings =
        Files.writeString(folder.resolve("r.csv"), "object,schema,rating\nsword,Desk,1\n");
    assertThat(run("enrich", scene().toString(), "--ratings", ratings.toString())).isEqualTo(1);
    assertThat(err)
        .contains("no Switch of the scene has the name 'sword'; its ratings are not used");
  }

  @Test
  void filesThatAreNotFoundFromTheOtherFolderAreTold() throws IOException {
    Files.writeString(folder.resolve("cup_v1.x3d"), "<X3D/>");
    String inlined = SCENE.replace("<Shape/>", "<Inline url='\"cup_v1.x3d\"'/>");
    Path scene = Files.writeString(folder.resolve("cup.x3d"), inlined);
    String table = table("Switch_Cup,0,schemaBelonginess,Desk\n").toString();
    Path beside = folder.resolve("enriched.x3d");
    run("enrich", scene.toString(), "--apply", table, "--output", beside.toString());
    assertThat(err).isEqualTo(beside + ": enriched\n");
    Path other = Files.createDirectory(folder.resolve("other")).resolve("cup.x3d");
    assertThat(run("enrich", scene.toString(), "--apply", table, "--output", other.toString()))
        .isZero();
    assertThat(err)
        .isEqualTo(
            """
            %1$s: 1 file that the scene refers to (cup_v1.x3d) cannot be found from this folder; \
            write the output into the folder of the scene, or copy these files too
            %1$s: enriched
            """
                .formatted(other));
  }

  @Test
  void wrongUsageIsTold() throws IOException {
    assertThat(run("enrich", scene().toString(), "--dry-run")).isEqualTo(2);
    assertThat(run("enrich", "--apply", "m.csv")).isEqualTo(2);
    assertThat(run("enrich", folder.resolve("no.x3d").toString(), "--apply", table("").toString()))
        .isEqualTo(2);
  }

  @Test
  void aFolderIsNoTable() throws IOException {
    for (String option : new String[] {"--apply", "--ratings"}) {
      assertThat(run("enrich", scene().toString(), option, folder.toString())).isEqualTo(2);
      assertThat(err)
          .isEqualTo("selective-renderer enrich: " + folder + ": is a folder, not a file\n");
    }
  }
}
