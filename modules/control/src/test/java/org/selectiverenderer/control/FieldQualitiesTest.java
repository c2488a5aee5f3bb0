package org.selectiverenderer.control;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.control.ControlEvent.FieldChange;
import org.selectiverenderer.control.ControlEvent.SwitchChange;
import org.selectiverenderer.control.SelectiveController.Settings;
import org.selectiverenderer.schema.Condition;
import org.selectiverenderer.schema.Quality;
import org.selectiverenderer.schema.QualityRule;
import org.web3d.x3d.sai.MFString;
import org.web3d.x3d.sai.SFBool;
import org.web3d.x3d.sai.SFFloat;
import org.web3d.x3d.sai.X3DNode;

class FieldQualitiesTest {
  private static final String AREAS = ControlledSceneFixture.area("Room", 0, "kitchen", "hall");

  private static String level(String degree, String schema, String value) {
    return "<MetadataSet><MetadataString name='degreeOfConsistency' value='\"%s\"'/>"
            .formatted(degree)
        + "<MetadataString name='schemaBelonginess' value='\"%s\"'/>".formatted(schema)
        + "<MetadataString name='value' value='%s'/></MetadataSet>".formatted(value);
  }

  private static String quality(String quality, String field, String low, String high) {
    return "<MetadataSet><MetadataString name='quality' value='\"%s\"'/>".formatted(quality)
        + "<MetadataString name='field' value='\"%s\"'/>".formatted(field)
        + level("low", "hall", low)
        + level("high", "kitchen", high)
        + "</MetadataSet>";
  }

  private static String object(String def, String child, String... qualities) {
    return "<Switch DEF='%s' whichChoice='0'>%s".formatted(def, child)
        + "<MetadataSet containerField='metadata'>"
        + "<MetadataSet name='fieldQualities' containerField='metadata'>"
        + String.join("", qualities)
        + "</MetadataSet></MetadataSet></Switch>";
  }

  private static final String SOFA =
      "<Group><Shape><Appearance><ImageTexture DEF='T' url='\"s.png\"' load='false'/>"
          + "<Material DEF='M' shininess='0.5'/></Appearance><Box/></Shape>"
          + "<DirectionalLight DEF='L'/><MetadataInteger DEF='I' value='1'/>"
          + "<Transform DEF='P'/></Group>";

  private static final String TEXTURES =
      quality("textures", "T.url", "\"s.png\"", "\"s_25.png\" \"http://a.b/s_25.png\"");

  private static List<String> url(ControlledSceneFixture scene) {
    MFString url = (MFString) scene.node("T").getField("url");
    String[] values = new String[url.getSize()];
    url.getValue(values);
    return List.of(values);
  }

  @Test
  void aLevelThatMayNotBeShownYetWaitsByTheNameOfItsField() {
    SwitchTiming never =
        new SwitchTiming() {
          @Override
          public boolean mayShow(X3DNode node, int choice) {
            return false;
          }

          @Override
          public Optional<SwitchVisibility> shows(X3DNode node, int choice) {
            return Optional.empty();
          }
        };
    try (ControlledSceneFixture scene =
        new ControlledSceneFixture(AREAS + object("Sofa", SOFA, TEXTURES))) {
      scene.control(Settings.SELECTIVE, never);
      scene.walkTo(0);
      assertThat(url(scene)).containsExactly("s.png");
      assertThat(scene.controller.waiting()).containsExactly(Map.entry("T.url", 1));
    }
  }

  @Test
  void anAreaSetsAFieldAndLeavingItSetsItBack() {
    try (ControlledSceneFixture scene =
        ControlledSceneFixture.under(Condition.SELECTIVE, AREAS + object("Sofa", SOFA, TEXTURES))) {
      assertThat(scene.problems).isEmpty();
      assertThat(scene.news())
          .containsExactly(new ControlEvent.Start(0, Map.of(), Map.of("Sofa", Map.of("T.url", 0))));
      scene.walkTo(0);
      assertThat(url(scene)).containsExactly("s_25.png", "http://a.b/s_25.png");
      assertThat(scene.news())
          .contains(new FieldChange(1, "Sofa", Quality.TEXTURES, "T.url", 0, 1, "kitchen"));
      scene.walkTo(9);
      assertThat(url(scene)).containsExactly("s.png");
      assertThat(scene.news())
          .contains(new FieldChange(2, "Sofa", Quality.TEXTURES, "T.url", 1, 0, "hall"));
    }
  }

  @Test
  void qualitiesAndVersionsChangeIndependently() {
    String vase =
        ControlledSceneFixture.object("DEF='Vase'", "kitchen", "hall")
            .replace(
                "<MetadataSet containerField='metadata'>",
                "<MetadataSet containerField='metadata'>"
                    + "<MetadataSet name='fieldQualities' containerField='metadata'>"
                    + quality("light", "L.on", "true", "false")
                    + "</MetadataSet>");
    Settings settings =
        new Settings(Condition.SELECTIVE, 7).with(Map.of(Quality.LIGHT, QualityRule.LOW));
    try (ControlledSceneFixture scene = new ControlledSceneFixture(AREAS + vase + SOFA)) {
      scene.control(settings);
      SFBool on = (SFBool) scene.node("L").getField("on");
      assertThat(on.getValue()).as("the worst level from the start").isFalse();
      scene.walkTo(0);
      assertThat(scene.choice("Vase")).isZero();
      scene.walkTo(9);
      assertThat(scene.choice("Vase")).isEqualTo(1);
      assertThat(on.getValue()).isFalse();
      assertThat(scene.events)
          .hasAtLeastOneElementOfType(SwitchChange.class)
          .doesNotHaveAnyElementsOfTypes(FieldChange.class);
      assertThat(scene.problems).isEmpty();
    }
  }

  @Test
  void aQualityFollowsTheAreasWhileVersionsAreAllHigh() {
    Settings settings =
        new Settings(Condition.HIGH, 7).with(Map.of(Quality.TEXTURES, QualityRule.SELECTIVE));
    String scenery =
        AREAS
            + object("Sofa", SOFA, TEXTURES)
            + ControlledSceneFixture.object("DEF='Vase'", "kitchen", "hall");
    try (ControlledSceneFixture scene = new ControlledSceneFixture(scenery)) {
      scene.control(settings);
      scene.walkTo(0);
      assertThat(url(scene)).hasSize(2);
      scene.walkTo(9);
      assertThat(url(scene)).hasSize(1);
      assertThat(scene.choice("Vase")).as("the least consistent version").isZero();
    }
  }

  @Test
  void conditionsSetEachFieldToTheLevelOfTheirConsistency() {
    String sofa =
        object("Sofa", SOFA, quality("shading", "M.shininess", "\"0.5\"", "\"0.25\""), TEXTURES);
    try (ControlledSceneFixture scene =
        ControlledSceneFixture.under(
            Condition.HIGH_LOW, ControlledSceneFixture.area("Room", 0, "kitchen", "") + sofa)) {
      assertThat(((SFFloat) scene.node("M").getField("shininess")).getValue()).isEqualTo(0.25f);
      assertThat(url(scene)).hasSize(2);
    }
  }

  @Test
  void eachFileThatIsInlinedSetsItsOwnField(@TempDir Path folder) throws IOException {
    Files.writeString(
        folder.resolve("sofa.x3d"), ControlledSceneFixture.file(object("Sofa", SOFA, TEXTURES)));
    String inlines =
        "<Inline DEF='A' url='\"sofa.x3d\"'/><Transform><Inline DEF='B' url='\"sofa.x3d\"'/>"
            + "</Transform>";
    try (ControlledSceneFixture scene = new ControlledSceneFixture(folder, AREAS + inlines)) {
      scene.control(Condition.SELECTIVE);
      scene.walkTo(0);
      assertThat(scene.events.stream().filter(FieldChange.class::isInstance))
          .extracting(event -> ((FieldChange) event).object())
          .containsExactly("A/Sofa", "B/Sofa");
    }
  }

  @Test
  void whatNamesNoFieldIsReportedWithItsObject() {
    String sofa =
        object(
            "Sofa",
            SOFA,
            quality("textures", "Nobody.url", "\"a\"", "\"b\""),
            quality("light", "L.off", "\"true\"", "\"false\""),
            quality("light", "L.on", "\"true\"", "\"dark\""),
            quality("light", "P.translation", "\"0 0 0\"", "\"0 0 0\""),
            quality("shading", "M.shininess", "\"0.5\"", "\"0.5 0.5\""));
    try (ControlledSceneFixture scene =
        ControlledSceneFixture.under(Condition.SELECTIVE, AREAS + sofa)) {
      assertThat(scene.problems.stream().filter(p -> p.nodeName().equals("Sofa")))
          .extracting(ControlProblem::message)
          .containsExactly(
              "textures of Nobody.url cannot be chosen: the file has no node with the DEF name"
                  + " Nobody",
              "light of L.off cannot be chosen: DirectionalLight L has no inputOutput field off",
              "light of L.on cannot be chosen: \"dark\" is no value of the field",
              "light of P.translation cannot be chosen: the field is of none of the types SFBool,"
                  + " SFInt32, SFFloat, SFDouble, SFTime, SFString, SFColor, MFString, MFInt32,"
                  + " MFFloat, MFDouble",
              "shading of M.shininess cannot be chosen: \"0.5 0.5\" is no value of the field");
      scene.walkTo(0);
      assertThat(scene.events).doesNotHaveAnyElementsOfTypes(FieldChange.class);
    }
  }

  @Test
  void aValueThatOthersSetStaysUntilTheNextActivation() {
    try (ControlledSceneFixture scene =
        ControlledSceneFixture.under(Condition.SELECTIVE, AREAS + object("Sofa", SOFA, TEXTURES))) {
      ((MFString) scene.node("T").getField("url")).setValue(1, new String[] {"other.png"});
      scene.walkTo(9);
      assertThat(url(scene)).containsExactly("other.png");
      scene.walkTo(0);
      assertThat(scene.news())
          .contains(new FieldChange(2, "Sofa", Quality.TEXTURES, "T.url", -1, 1, "kitchen"));
    }
  }

  @Test
  void levelsThatChangeAreReadAnew() {
    try (ControlledSceneFixture scene =
        ControlledSceneFixture.under(
            Condition.SELECTIVE,
            AREAS
                + object(
                    "Sofa",
                    SOFA,
                    quality("light", "L.on", "\"true\"", "\"false\"")
                        .replace("name='field'", "DEF='Field' name='field'")))) {
      scene.walkTo(0);
      assertThat(((SFBool) scene.node("L").getField("on")).getValue()).isFalse();
      ((MFString) scene.node("Field").getField("value")).setValue(1, new String[] {"L.global"});
      scene.walkTo(0);
      assertThat(((SFBool) scene.node("L").getField("global")).getValue()).isFalse();
      scene.walkTo(9);
      assertThat(((SFBool) scene.node("L").getField("global")).getValue()).isTrue();
      assertThat(((SFBool) scene.node("L").getField("on")).getValue()).isFalse();
    }
  }

  @Test
  void aSceneThatSetsItselfIsObserved() {
    try (ControlledSceneFixture scene =
        new ControlledSceneFixture(object("Sofa", SOFA, TEXTURES))) {
      scene.control(Settings.OBSERVING);
      scene.news();
      ((MFString) scene.node("T").getField("url"))
          .setValue(2, new String[] {"s_25.png", "http://a.b/s_25.png"});
      scene.walkTo(0);
      assertThat(scene.news())
          .anyMatch(
              event ->
                  event instanceof FieldChange change
                      && change.from() == 0
                      && change.to() == 1
                      && change.schema().isEmpty());
    }
  }
}
