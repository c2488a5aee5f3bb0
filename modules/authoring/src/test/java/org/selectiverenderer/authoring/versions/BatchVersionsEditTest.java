package org.selectiverenderer.authoring.versions;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.tuple;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CancellationException;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.file.DocumentFile;
import org.selectiverenderer.authoring.versions.VersionCandidate.Remark;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.models.simplify.SimplificationTarget;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.TextEdit;

/** Makes versions of many objects of an office as a modeller writes it, without names. */
class BatchVersionsEditTest {
  private static final String SCENE =
      """
      <X3D profile='Immersive' version='3.3'>
        <Scene>
          <!-- floor -->
          <Transform translation='0 -0.05 0'>
            <Shape><Appearance><Material/></Appearance><Box size='10 0.1 8'/></Shape>
          </Transform>
          <Transform translation='0 1.5 -4'>
            <Shape>
              <Appearance><ImageTexture url='"textures/Brick_Wall.png"'/></Appearance>
              <ElevationGrid xDimension='20' zDimension='20' xSpacing='0.5' zSpacing='0.15'
                  height='%s'/>
            </Shape>
          </Transform>
          <!-- the office chair -->
          <Transform translation='2 0.5 1'>
            <Shape><Appearance><Material DEF='Leather'/></Appearance><Sphere radius='.4'/></Shape>
            <Transform translation='0 -0.4 0'>
              <Shape><Cylinder radius='.05' height='.5'/></Shape>
              <Shape><Sphere radius='.1'/></Shape>
            </Transform>
          </Transform>
          <Transform translation='-2 0.5 1'>
            <Shape>
              <Appearance><Material DEF='material_Leather2'/></Appearance>
              <Sphere radius='.4'/>
            </Shape>
          </Transform>
          <Shape><Sphere radius='.2'/></Shape>
          <Group DEF='Group_Lamp'><Shape><Sphere radius='.2'/></Shape></Group>
          <Transform DEF='Transform_Lamp'><Shape><Sphere radius='.3'/></Shape></Transform>
          <Transform DEF='Shared' translation='1 1 1'><Shape DEF='Ball'><Sphere/></Shape></Transform>
          <Transform translation='-3 1 1'><Shape USE='Ball'/></Transform>
        </Scene>
      </X3D>
      """
          .formatted("0 ".repeat(400).strip());

  @TempDir Path folder;

  private final NodeCatalogue catalogue = NodeCatalogue.load();
  private final ProblemCollector problems = new ProblemCollector();

  private DocumentFile open(String scene) throws IOException {
    return DocumentFile.open(Files.writeString(folder.resolve("office.x3d"), scene));
  }

  private VersionsEdit.Request request(DocumentFile file) {
    return new VersionsEdit.Request(file.path(), "", List.of(), "inlineNodes");
  }

  private List<VersionCandidate> candidates(DocumentFile file) throws IOException {
    return VersionCandidateFinder.find(
        file.document().snapshot(), request(file), List.of(), catalogue, (share, name) -> {});
  }

  private BatchVersionsEdit plan(DocumentFile file, SimplificationTarget goal) throws IOException {
    return BatchVersionsEdit.plan(
        file.document().snapshot(),
        request(file),
        candidates(file).stream()
            .filter(VersionCandidate::proposed)
            .map(object -> new BatchVersionsEdit.Item(object, List.of(goal)))
            .toList(),
        catalogue,
        (share, name) -> {},
        problems);
  }

  @Test
  void aSceneOfALowerProfileDeclaresWhatTheVersionsNeedOnce() throws IOException {
    DocumentFile file = open(SCENE.replace("'Immersive'", "'Interchange'"));
    plan(file, new SimplificationTarget.VertexPercent(50)).apply(file.document());
    assertThat(file.document().text().toString())
        .containsOnlyOnce(
            "  <head>\n    <component name='Grouping' level='2'/>\n"
                + "    <component name='Networking' level='2'/>\n  </head>\n")
        .containsOnlyOnce("<component name='Grouping'");
    file.document().history().undo();
    assertThat(file.document().text().toString()).doesNotContain("component");
  }

  @Test
  void wholePiecesAreProposedAndWallsAndFloorsAreNot() throws IOException {
    Map<String, Remark> remarks =
        candidates(open(SCENE)).stream()
            .collect(Collectors.toMap(VersionCandidate::name, VersionCandidate::remark));
    assertThat(remarks)
        .containsOnly(
            Map.entry("Floor", Remark.FLAT),
            Map.entry("Brick_Wall", Remark.FLAT),
            Map.entry("Office_chair", Remark.NONE),
            Map.entry("Leather2", Remark.NONE),
            Map.entry("Sphere", Remark.NONE),
            Map.entry("Group_Lamp", Remark.NONE),
            Map.entry("Transform_Lamp", Remark.NONE),
            Map.entry("Shared", Remark.NONE),
            Map.entry("Ball_2", Remark.SHARED));
  }

  @Test
  void aGroupWithSwitchesIsARoomAndItsPiecesAreProposed() throws IOException {
    DocumentFile file =
        open(
            """
            <X3D version='3.3'><Scene>
              <Group DEF='Room'>
                <Transform DEF='Vase'><Shape><Sphere radius='.1'/></Shape></Transform>
                <Transform DEF='Bowl'>
                  <Switch DEF='Switch_Bowl' whichChoice='0'>
                    <Inline url='"Bowl_v1.x3d"'/>
                  </Switch>
                </Transform>
              </Group>
              <Transform DEF='Tree' translation='5 0 0'>
                <Shape><Sphere/></Shape><Shape><Cylinder/></Shape>
              </Transform>
            </Scene></X3D>
            """);
    Files.writeString(
        folder.resolve("Bowl_v1.x3d"),
        "<X3D version='3.3'><Scene><Shape><Sphere/></Shape></Scene></X3D>");
    assertThat(candidates(file))
        .extracting(VersionCandidate::name, VersionCandidate::remark)
        .containsExactly(
            tuple("Vase", Remark.NONE), tuple("Bowl", Remark.VERSIONS), tuple("Tree", Remark.NONE));
  }

  @Test
  void anObjectThatARouteLeadsToTellsWhy() throws IOException {
    String route =
        "<TouchSensor DEF='T'/><ROUTE fromNode='T' fromField='isOver' toNode='Ball'"
            + " toField='visible'/>";
    assertThat(candidates(open(SCENE.replace("</Scene>", route + "</Scene>"))))
        .filteredOn(object -> object.name().equals("Shared"))
        .singleElement()
        .satisfies(
            object -> assertThat(object.obstacle()).contains("the ROUTE here refers to 'Ball'"));
  }

  @Test
  void theElementsThatTheAuthorChoosesAreTakenWhateverTheyAre() throws IOException {
    DocumentFile file = open(SCENE);
    String text = file.document().text().toString();
    int floor = text.indexOf("<Transform translation='0 -0.05");
    int chair = text.indexOf("<Transform translation='2 0.5");
    int leg = text.indexOf("<Transform translation='0 -0.4");
    int material = text.indexOf("<Material DEF='material_Leather2");
    List<VersionCandidate> found =
        VersionCandidateFinder.find(
            file.document().snapshot(),
            request(file),
            List.of(floor, chair, leg, material),
            catalogue,
            (share, name) -> {});
    assertThat(found)
        .extracting(VersionCandidate::name)
        .containsExactly("Floor", "Office_chair", "Leather2");
    assertThat(found).allMatch(VersionCandidate::proposed);
  }

  @Test
  void allVersionsAreOneStepWithTheirFilesAndNamesAreGiven() throws IOException {
    DocumentFile file = open(SCENE);
    SceneDocument document = file.document();
    BatchVersionsEdit plan = plan(file, new SimplificationTarget.VertexPercent(20));
    assertThat(problems.list()).isEmpty();
    assertThat(folder.resolve("inlineNodes")).doesNotExist();
    plan.apply(document);
    assertThat(plan.objects())
        .extracting(BatchVersionsEdit.VersionedObject::name)
        .containsExactly( // in the order of the scene
            "Office_chair", "Leather2", "Sphere", "Group_Lamp", "Transform_Lamp", "Shared");
    assertThat(document.text().toString())
        .contains("<Transform DEF='Office_chair' translation='2 0.5 1'>")
        .contains("<Switch DEF='Switch_Office_chair' whichChoice='0'>")
        .contains("<Switch DEF='Switch_Sphere' whichChoice='0'>")
        .contains("url='\"inlineNodes/Lamp_v2.x3d\"'")
        .contains("Lamp_2_v2.x3d\"'")
        .contains("<Transform translation='0 -0.05 0'>");
    try (Stream<Path> files = Files.list(folder.resolve("inlineNodes"))) {
      assertThat(files).hasSize(12);
    }
    document.history().undo();
    assertThat(document.text().toString()).isEqualTo(SCENE);
    assertThat(document.history().undoName()).isEmpty();
    assertThat(folder.resolve("inlineNodes/Office_chair_v2.x3d")).doesNotExist();
  }

  @Test
  void theTransformOfAnInstanceIsProposedTheNameOfItsPrototype() throws IOException {
    DocumentFile file =
        open(
            """
            <X3D version='3.3'><Scene>
              <ProtoDeclare name='Chair'><ProtoBody>
                <Shape><Sphere/></Shape>
              </ProtoBody></ProtoDeclare>
              <Transform translation='1 0 0'><ProtoInstance name='Chair'/></Transform>
              <Transform translation='2 0 0'><ProtoInstance name='Chair'/></Transform>
            </Scene></X3D>
            """);
    assertThat(candidates(file))
        .extracting(VersionCandidate::name)
        .containsExactly("Chair", "Chair_2");
  }

  /** A number would tell of a second chair. */
  @Test
  void theTransformOfANamedNodeIsProposedThatNameWithItsType() throws IOException {
    DocumentFile file =
        open(
            """
            <X3D version='3.3'><Scene>
              <ProtoDeclare name='Chair'><ProtoBody>
                <Shape><Sphere/></Shape>
              </ProtoBody></ProtoDeclare>
              <Transform translation='1 0 0'><ProtoInstance DEF='ChairHall' name='Chair'/></Transform>
            </Scene></X3D>
            """);
    assertThat(candidates(file))
        .extracting(VersionCandidate::name)
        .containsExactly("Transform_ChairHall");
  }

  @Test
  void theChangeOfManyObjectsLeavesTheOtherBytesAlone() throws IOException {
    DocumentFile file = open(SCENE.replace("\n", "\r\n"));
    BatchVersionsEdit plan = plan(file, new SimplificationTarget.LargestError(0.05));
    plan.write();
    String written = Files.readString(file.path(), StandardCharsets.UTF_8);
    List<String> lines = new ArrayList<>(List.of(written.split("\r\n", -1)));
    assertThat(lines).noneMatch(line -> line.contains("\n"));
    assertThat(written)
        .contains("<Transform translation='-3 1 1'><Switch USE='Switch_Shared'/></Transform>");
    assertThat(plan.objects())
        .allSatisfy(
            object ->
                assertThat(object.versions().get(1).polygons())
                    .isLessThan(object.versions().get(0).polygons()));
  }

  @Test
  void aTransformAroundAnInstanceIsNamedAfterItsPrototype() throws IOException {
    DocumentFile file =
        open(
            """
            <X3D profile='Immersive' version='3.3'><Scene>
              <ProtoDeclare name='Lamp'>
                <ProtoInterface>
                  <field accessType='initializeOnly' name='shade' type='SFColor' value='1 .9 .5'/>
                </ProtoInterface>
                <ProtoBody><Transform><Shape><Sphere/></Shape></Transform></ProtoBody>
              </ProtoDeclare>
              <Transform translation='-1 .3 2'>
                <ProtoInstance name='Lamp'><fieldValue name='shade' value='.9 .2 .2'/></ProtoInstance>
              </Transform>
              <Transform translation='4 .3 3'><ProtoInstance name='Lamp'/></Transform>
            </Scene></X3D>
            """);
    assertThat(candidates(file))
        .extracting(VersionCandidate::name)
        .containsExactly("Lamp", "Lamp_2");
  }

  @Test
  void cancellingWritesNothing() throws IOException {
    DocumentFile file = open(SCENE);
    List<BatchVersionsEdit.Item> items =
        candidates(file).stream()
            .filter(VersionCandidate::proposed)
            .map(
                object ->
                    new BatchVersionsEdit.Item(
                        object, List.of(new SimplificationTarget.VertexPercent(50))))
            .toList();
    assertThatThrownBy(
            () ->
                BatchVersionsEdit.plan(
                    file.document().snapshot(),
                    request(file),
                    items,
                    catalogue,
                    (share, name) -> {
                      if (share > 0.3) {
                        throw new CancellationException();
                      }
                    },
                    problems))
        .isInstanceOf(CancellationException.class);
    assertThat(folder.resolve("inlineNodes")).doesNotExist();
    assertThat(file.document().text().toString()).isEqualTo(SCENE);
  }

  @Test
  void editsOneAfterTheOtherComposeToChangesOfTheFirstText() {
    ComposedEdit composed = new ComposedEdit("abcdef");
    composed.add(List.of(new TextEdit(1, 2, "BB")));
    composed.add(List.of(new TextEdit(0, 0, ">"), new TextEdit(2, 5, "x")));
    assertThat(composed.text()).isEqualTo(">aBxef");
    assertThat(TextEdit.applied(composed.changes(), "abcdef").toString())
        .isEqualTo(composed.text());
  }
}
