package org.selectiverenderer.cli.author;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.cli.CommandTestCase;
import org.selectiverenderer.study.gaze.GazeSimulator;

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

  @Test
  void aScaleReachesTheLastVersionAndValidates() throws IOException {
    Path scene =
        Files.writeString(
            folder.resolve("cup.x3d"),
            """
            <?xml version='1.0' encoding='UTF-8'?>
            <X3D profile='Immersive' version='3.3'><Scene>
              <Viewpoint position='0 0 4'/>
              <ProximitySensor DEF='DeskProx' size='9 9 9'/>
              <Shape DEF='Cup'><Appearance><Material/></Appearance><Sphere/></Shape>
            </Scene></X3D>
            """);
    run("versions", scene.toString(), "--object", "Cup", "--vert-percent", "60,35,10");
    Path ratings = folder.resolve("r.csv");
    Files.writeString(ratings, "object,schema,rating\nCup,DeskSchema,3\n");
    assertThat(
            run(
                "enrich",
                scene.toString(),
                "--ratings",
                ratings.toString(),
                "--rating-scale",
                "linear"))
        .as(err)
        .isZero();

    assertThat(Files.readString(scene)).contains("\"0.3333\"", "\"0.6667\"", "\"high\"");
    run("validate", scene.toString());
    assertThat(out).doesNotContain("SR409", "SR416", "SR417");
    Path walk = Files.writeString(folder.resolve("walk.csv"), "t,x,y,z\n0,0,0,0\n1,0,0,0\n");
    run("simulate", scene.toString(), "--path", walk.toString(), "--quality", "polygons=low");
    assertThat(out).contains("start   Switch_Cup: choice 3");
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

  /** A room of objects in two versions, and a study with participants who looked at them. */
  private Path roomWithLogs(int participants) throws IOException {
    double[] attention = {1, -1, 0, 1, -1, 0, 1, -1, 0, 1, -1, 0, 1, -1, 0, 0};
    GazeSimulator room =
        new GazeSimulator("room.x3d", List.of("OfficeSchema"), GazeSimulator.along(attention, 1));
    for (int p = 1; p <= participants; p++) {
      GazeSimulator.write(
          room.log(60, p),
          folder.resolve("study/sub-%02d/ses-01/head/room_run-01.csv".formatted(p)));
    }
    StringBuilder scene = new StringBuilder("<X3D><Scene>\n");
    for (int i = 1; i <= attention.length; i++) {
      scene.append("  <Switch DEF='Switch_Object%d'><Shape/><Shape/></Switch>\n".formatted(i));
    }
    return Files.writeString(folder.resolve("room.x3d"), scene + "</Scene></X3D>\n");
  }

  @Test
  void whatParticipantsLookedAtIsProposedAndWhatIsClearIsWritten() throws IOException {
    Path scene = roomWithLogs(12);
    String before = Files.readString(scene);
    String logs = folder.resolve("study").toString();
    assertThat(run("enrich", scene.toString(), "--from-logs", logs)).as(err).isZero();
    assertThat(out)
        .containsPattern("Switch_Object1 +OfficeSchema +- +0\\.[0-3].* 12 .* inconsistent\n")
        .containsPattern("Switch_Object5 +OfficeSchema +- +0\\.[6-9].* 12 .* consistent\n")
        .containsPattern("Switch_Object9 .*undecided\n");
    assertThat(err).contains("of 16 proposals are clear").contains("room.x3d: enriched");
    assertThat(Files.readString(scene)).contains("OfficeSchema", "\"inconsistent\"");
    assertThat(folder.resolve("room.x3d.bak")).hasContent(before);
    assertThat(Files.readString(scene).replaceAll("(?m)^\\s*</?Metadata.*\n", ""))
        .contains("<Switch DEF='Switch_Object9'><Shape/><Shape/></Switch>\n");
  }

  @Test
  void aDryRunOfLogsPrintsTheTableAndTheDifference() throws IOException {
    Path scene = roomWithLogs(6);
    String before = Files.readString(scene);
    String logs = folder.resolve("study").toString();
    assertThat(run("enrich", scene.toString(), "--from-logs", logs, "--dry-run")).as(err).isZero();
    assertThat(out).startsWith("object ").contains("undecided", "\n--- ", "\n+++ ");
    assertThat(err).doesNotContain("Switch_Object1");
    assertThat(scene).hasContent(before);
  }

  @Test
  void ratingsAreWhatProposalsAreShrunkTowards() throws IOException {
    Path scene = roomWithLogs(2);
    Path ratings =
        Files.writeString(
            folder.resolve("r.csv"),
            "object,schema,rating\nObject1,OfficeSchema,1\nNobody,OfficeSchema,3\n");
    String logs = folder.resolve("study").toString();
    run("enrich", scene.toString(), "--from-logs", logs, "--ratings", ratings.toString());
    assertThat(out).containsPattern("Switch_Object1 +OfficeSchema +1\\.00 ");
    assertThat(err).contains("no Switch of the scene has the name 'Nobody'");
  }

  @Test
  void onePersonsLogsProposeNothing() throws IOException {
    Path scene = roomWithLogs(1);
    String before = Files.readString(scene);
    assertThat(run("enrich", scene.toString(), "--from-logs", folder.resolve("study").toString()))
        .isZero();
    assertThat(err)
        .contains("one participant only", "name the logs of others too", "0 of 16 proposals")
        .contains("no proposal is clear enough; nothing is written")
        .doesNotContain("has all of this metadata");
    assertThat(scene).hasContent(before);
  }

  @Test
  void whereAllLogsAreOfAnotherSceneNothingIsSaidOfWhatWasInView() throws IOException {
    Path room = roomWithLogs(2);
    Path other = Files.copy(room, folder.resolve("other.x3d"));
    assertThat(run("enrich", other.toString(), "--from-logs", folder.resolve("study").toString()))
        .isZero();
    assertThat(err)
        .contains("left out: logs of other scenes (room.x3d)", "no log is used")
        .doesNotContain("in view for a second", "has all of this metadata");
    assertThat(out).isEmpty();
  }

  @Test
  void logsThatAreNoneAreSaidInASentence() throws IOException {
    Path scene = scene();
    assertThat(run("enrich", scene.toString(), "--from-logs", scene.toString())).isEqualTo(1);
    assertThat(err).contains("cup.x3d:1:");
    assertThat(run("enrich", scene.toString(), "--from-logs", folder + "/none.csv")).isNotZero();
    assertThat(err).contains("none.csv").contains("does not exist").doesNotContain("Exception");
    assertThat(run("enrich", "--from-logs", "a.csv")).isNotZero();
    assertThat(err).contains("need a SCENE");
  }
}
