package org.selectiverenderer.enricher.form;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.awt.Point;
import java.awt.event.KeyEvent;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import javax.accessibility.Accessible;
import javax.swing.AbstractButton;
import javax.swing.JCheckBox;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JTable;
import javax.swing.JViewport;
import javax.swing.SwingUtilities;
import javax.swing.text.JTextComponent;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.enricher.EventThread;
import org.selectiverenderer.testing.Eventually;
import org.selectiverenderer.testing.ShowsWindows;

@ShowsWindows
@Timeout(value = 120, unit = TimeUnit.SECONDS)
class FormPanelTest {
  private static final String SCENE =
      """
      <?xml version="1.0" encoding="UTF-8"?>
      <X3D profile='Immersive' version='4.0'><Scene>
        <ProximitySensor DEF='Desk' size='3 3 3'>
          <MetadataSet containerField='metadata'>
            <MetadataString containerField='value' name='enterTimeSchema' value='"DeskSchema"'/>
          </MetadataSet>
        </ProximitySensor>
        <Switch DEF='Switch_Bin' whichChoice='0'>
          <Shape DEF='Low'><Appearance><Material diffuseColor='0 1 0'/></Appearance>
            <Box size='1 1 1'/></Shape>
          <Inline DEF='High' url='"bin.x3d"'/>
        </Switch>
        <Transform DEF='Table'><Shape><Box/></Shape></Transform>
        <Inline/>
      </Scene></X3D>
      """;

  @TempDir Path folder;

  private FormWindowDriver open(boolean dark) throws Exception {
    Files.writeString(
        folder.resolve("bin.x3d"),
        "<X3D profile='Immersive' version='4.0'><Scene><Shape><Appearance><Material/></Appearance>"
            + "<Sphere/></Shape></Scene></X3D>");
    return new FormWindowDriver(Files.writeString(folder.resolve("scene.x3d"), SCENE), dark);
  }

  private static String shown(Component control) {
    return EventThread.get(
        () ->
            control instanceof JComboBox<?> box
                ? String.valueOf(
                    box.isEditable() ? box.getEditor().getItem() : box.getSelectedItem())
                : ((JTextComponent) control).getText());
  }

  private static Component editor(Component box) {
    return ((JComboBox<?>) box).getEditor().getEditorComponent();
  }

  private static Object outline(Component control) {
    return EventThread.get(() -> ((JComponent) control).getClientProperty("JComponent.outline"));
  }

  @Test
  void anyFieldOfANodeIsEditedMarkedAndGivenItsDefaultBack() throws Exception {
    try (FormWindowDriver window = open(false)) {
      EventThread.edt(
          () ->
              window.session.select(
                  window
                      .session
                      .document()
                      .tree()
                      .orElseThrow()
                      .named("Low")
                      .orElseThrow()
                      .children()
                      .get(0)
                      .children()
                      .get(0),
                  this));
      JTextComponent colour = (JTextComponent) window.named("field diffuseColor");
      window.fill(colour, "1 0 2");
      window.press(KeyEvent.VK_ENTER);
      assertThat(outline(colour)).isEqualTo("error");
      assertThat(window.text("Low")).contains("diffuseColor='0 1 0'");
      window.fill(colour, "1 0 0");
      window.press(KeyEvent.VK_ENTER);
      assertThat(outline(colour)).isNull();
      assertThat(window.text("Low")).contains("diffuseColor='1 0 0'");
      EventThread.edt(((JCheckBox) window.named("allFields"))::doClick);
      JComponent transparency = (JComponent) window.named("field transparency");
      EventThread.edt(transparency::requestFocusInWindow);
      Eventually.await("the keyboard", () -> EventThread.get(transparency::isFocusOwner));
      window.fill(transparency, "0.5");
      window.press(KeyEvent.VK_ENTER);
      window.screenshot("form-fields", 1);
      assertThat(window.text("Low"))
          .contains("<Material diffuseColor='1 0 0' transparency='0.5'/>");
      EventThread.edt(((AbstractButton) window.named("reset transparency"))::doClick);
      assertThat(window.text("Low")).contains("<Material diffuseColor='1 0 0'/>");
      assertThat(EventThread.get(() -> window.session.document().history().names())).hasSize(3);
    }
  }

  @Test
  void aNodeWithoutATransformGetsOneByItsRowsAndKeepsTheKeyboard() throws Exception {
    try (FormWindowDriver window = open(false)) {
      window.select("Table");
      Component body = window.named("allFields").getParent().getParent();
      assertThat(EventThread.get(() -> FormWindowDriver.all(body).toList()))
          .noneMatch(each -> "placement translation".equals(each.getName()));
      window.select("Low");
      String before = window.text("Low");
      window.fill(window.named("placement translation"), "1 0");
      window.press(KeyEvent.VK_ENTER);
      assertThat(outline(window.named("placement translation"))).isEqualTo("error");
      assertThat(window.text("Low")).isEqualTo(before);
      window.fill(window.named("placement translation"), "1 0 -2.5");
      window.press(KeyEvent.VK_ENTER);
      Eventually.await(
          "the keyboard in the new form",
          () -> window.named("placement translation").isFocusOwner());
      String text = EventThread.get(() -> window.session.document().text().toString());
      assertThat(text).containsPattern("<Transform translation='1 0 -2.5'>\\s+<Shape DEF='Low'");
      assertThat(shown(window.named("placement translation"))).isEqualTo("1 0 -2.5");
      assertThat(EventThread.get(() -> window.session.selection().orElseThrow().def()))
          .contains("Low");
      window.fill(window.named("placement rotation"), "0 1 0 0.5");
      window.press(KeyEvent.VK_ENTER);
      window.screenshot("form-placement", 1);
      assertThat(EventThread.get(() -> window.session.document().text().toString()))
          .contains("<Transform translation='1 0 -2.5' rotation='0 1 0 0.5'>");
      assertThat(EventThread.get(() -> window.session.document().history().names()))
          .containsExactly("Move Low", "Turn Low");
      EventThread.edt(() -> window.session.document().history().undo());
      EventThread.edt(() -> window.session.document().history().undo());
      assertThat(EventThread.get(() -> window.session.document().text().toString()))
          .isEqualTo(SCENE);
    }
  }

  @Test
  void theFormOfAnotherNodeBeginsWithItsName() throws Exception {
    Path scene = Path.of("scenes", "trashcan.x3d");
    try (FormWindowDriver window = new FormWindowDriver(scene, false)) {
      JViewport view =
          FormWindowDriver.all(window.form)
              .filter(JViewport.class::isInstance)
              .map(JViewport.class::cast)
              .findFirst()
              .orElseThrow();
      EventThread.edt(() -> SwingUtilities.getWindowAncestor(view).setSize(900, 640));
      for (int time = 0; time < 2; time++) {
        window.select("Switch_TrashCan");
        JLabel polygons = (JLabel) window.named("Polygons of choice 1");
        Eventually.await(
            "the count", () -> EventThread.get(polygons::getText).endsWith("polygons"));
        EventThread.edt(() -> {}); // what was put off until the form has its place
        assertThat(EventThread.get(view::getViewPosition)).isEqualTo(new Point(0, 0));
        assertThat(EventThread.get(() -> view.getView().getHeight()))
            .isGreaterThan(view.getHeight());
        EventThread.edt(() -> view.setViewPosition(new Point(0, 60)));
        EventThread.edt(() -> window.session.select(null, this));
      }
    }
  }

  @Test
  void allSchemasAreListedOnCtrlSpaceInAnEmptyField() throws Exception {
    try (FormWindowDriver window = open(false)) {
      window.select("Switch_Bin");
      SchemaListField schemas = (SchemaListField) window.named("Schemas of choice 0");
      window.click(schemas);
      window.robot.keyPress(KeyEvent.VK_CONTROL);
      window.press(KeyEvent.VK_SPACE);
      window.robot.keyRelease(KeyEvent.VK_CONTROL);
      Eventually.await("the proposals", () -> EventThread.get(schemas::proposing));
      window.press(KeyEvent.VK_ENTER);
      assertThat(shown(schemas)).isEqualTo("DeskSchema");
    }
  }

  @Test
  void enterTakesTheOnlyProposal() throws Exception {
    try (FormWindowDriver window = open(false)) {
      window.select("Switch_Bin");
      SchemaListField schemas = (SchemaListField) window.named("Schemas of choice 0");
      window.fill(schemas, "des");
      Eventually.await("the proposal", () -> EventThread.get(schemas::proposing));
      window.press(KeyEvent.VK_ENTER);
      assertThat(shown(schemas)).isEqualTo("DeskSchema");
    }
  }

  @Test
  void whatIsFilledInIsWrittenUndoneAndShownForAnother() throws Exception {
    try (FormWindowDriver window = open(false)) {
      window.select("Switch_Bin");
      JComboBox<?> type = (JComboBox<?>) window.named("Type of choice 0");
      EventThread.edt(() -> type.setSelectedItem("consistent"));
      assertThat(window.text("Switch_Bin")).contains("consistencyType", "\"consistent\"");

      Component degree = window.named("Degree of choice 0");
      window.fill(editor(degree), "0.5");
      window.press(KeyEvent.VK_ENTER);
      assertThat(window.text("Switch_Bin")).contains("degreeOfConsistency", "0.5");

      Component schemas = window.named("Schemas of choice 0");
      window.fill(schemas, "des");
      window.press(KeyEvent.VK_DOWN);
      window.press(KeyEvent.VK_ENTER);
      assertThat(shown(schemas)).isEqualTo("DeskSchema");
      window.press(KeyEvent.VK_TAB);
      assertThat(window.text("Switch_Bin")).contains("schemaBelonginess", "\"DeskSchema\"");
      assertThat(EventThread.get(() -> window.session.document().history().names())).hasSize(3);

      EventThread.edt(() -> window.session.document().history().undo());
      assertThat(shown(schemas)).isEmpty();
      EventThread.edt(() -> window.session.document().history().undo());
      assertThat(shown(degree)).isEqualTo("none");
      EventThread.edt(() -> window.session.document().history().undo());
      assertThat(shown(type)).isEqualTo("none");
      assertThat(EventThread.get(() -> window.session.document().text().toString()))
          .isEqualTo(SCENE);

      window.select("Desk");
      assertThat(shown(window.named("On entering"))).isEqualTo("DeskSchema");
      window.fill(window.named("On leaving"), "office");
      window.select("Switch_Bin"); // What has been typed is not lost.
      assertThat(window.text("Desk")).contains("exitTimeSchema", "\"office\"");
      assertThat(window.messages).isEmpty();
    }
  }

  @Test
  void fromTheFirstSchemaOfAnAreaTabGoesOnToWhatLeavingActivates() throws Exception {
    try (FormWindowDriver window = open(false)) {
      int end = SCENE.indexOf("</Scene>");
      EventThread.edt(
          () -> window.session.document().type(end, end, "<ProximitySensor DEF='Sofa'/>"));
      window.select("Sofa");
      Component leaving = window.named("On leaving");
      window.fill(window.named("On entering"), "sofa");
      window.press(KeyEvent.VK_TAB);
      assertThat(window.text("Sofa")).contains("enterTimeSchema", "\"sofa\"");
      assertThat(window.named("On leaving")).isSameAs(leaving);
      assertThat(EventThread.get(leaving::isFocusOwner)).isTrue();
    }
  }

  @Test
  void noFieldMovesUnderTheMouseWhenThereIsSomethingToSay() throws Exception {
    try (FormWindowDriver window = open(false)) {
      window.select("Switch_Bin");
      Component schemas = window.named("Schemas of choice 1");
      EventThread.edt(() -> {});
      Point before = EventThread.get(schemas::getLocationOnScreen);
      Component degree = window.named("Degree of choice 0");
      window.fill(editor(degree), "2");
      window.click(schemas);
      assertThat(outline(degree)).isEqualTo("error");
      assertThat(EventThread.get(schemas::getLocationOnScreen)).isEqualTo(before);
      assertThat(EventThread.get(schemas::isFocusOwner)).isTrue();
      window.fill(editor(degree), "0.5");
      JComboBox<?> type = (JComboBox<?>) window.named("Type of choice 0");
      EventThread.edt(() -> type.setSelectedItem("consistent"));
      JLabel said = (JLabel) window.named("Findings");
      Eventually.await("a finding", () -> EventThread.get(said::getText).contains("problem"));
      window.screenshot("form-findings", 1);
      assertThat(EventThread.get(schemas::getLocationOnScreen)).isEqualTo(before);
    }
  }

  @Test
  void whatTheValidatorSaysOfANodeStandsInItsFormToo() throws Exception {
    try (FormWindowDriver window = open(false)) {
      window.select("Desk");
      Eventually.await("the finding of SR404", () -> window.texts().contains("no exitTimeSchema"));
      JLabel said = (JLabel) window.named("Findings");
      assertThat(EventThread.get(said::getText)).startsWith("2 problems"); // and an unused schema
    }
  }

  @Test
  void aFieldOfUrlsIsShownBeforeItIsWrittenWithAButtonToChooseAFile() throws Exception {
    try (FormWindowDriver window = open(false)) {
      EventThread.edt(
          () ->
              window.session.select(
                  window
                      .session
                      .document()
                      .tree()
                      .orElseThrow()
                      .scene()
                      .orElseThrow()
                      .children()
                      .get(3),
                  this));
      JTextComponent url = (JTextComponent) window.named("field url");
      assertThat(window.named("file of url")).isNotNull();
      window.fill(url, "bin.x3d");
      window.press(KeyEvent.VK_ENTER);
      assertThat(EventThread.get(() -> window.session.document().snapshot().text()))
          .contains("<Inline url='\"bin.x3d\"'/>");
    }
  }

  @Test
  void whatMeansNothingIsMarkedAndNotWritten() throws Exception {
    try (FormWindowDriver window = open(false)) {
      window.select("Switch_Bin");
      Component degree = window.named("Degree of choice 1");
      window.fill(editor(degree), "2");
      window.press(KeyEvent.VK_TAB);
      assertThat(outline(degree)).isEqualTo("error");
      assertThat(EventThread.get(() -> window.session.document().modified())).isFalse();
      assertThat(
              EventThread.get(
                  () ->
                      FormWindowDriver.all(window.form)
                          .filter(c -> c instanceof JLabel && c.isShowing())
                          .map(c -> ((JLabel) c).getText())
                          .toList()))
          .anyMatch(text -> text.contains("a number from 0"));
      window.screenshot("form-wrong", 1);
      window.fill(editor(degree), "high");
      window.press(KeyEvent.VK_ENTER);
      assertThat(outline(degree)).isNull();
      assertThat(window.text("Switch_Bin")).contains("\"high\"");
    }
  }

  @Test
  void otherElementsSayWhatCanBeDone() throws Exception {
    try (FormWindowDriver window = open(false)) {
      List<String> wanted = new CopyOnWriteArrayList<>();
      EventThread.edt(() -> window.form.onMakeVersions(e -> wanted.add(e.toString())));
      window.select("Table");
      AbstractButton make =
          EventThread.get(
              () ->
                  (AbstractButton)
                      FormWindowDriver.all(window.form)
                          .filter(
                              c -> c instanceof AbstractButton b && b.getText().startsWith("Make"))
                          .findAny()
                          .orElseThrow());
      window.click(make);
      assertThat(wanted).containsExactly("Transform Table");
      window.select("High");
      assertThat(
              EventThread.get(
                  () ->
                      ElementSummary.of(
                              window.session.document(),
                              window.session.catalogue(),
                              window.session.selection().orElseThrow())
                          .advice()))
          .contains("part of Switch Switch_Bin");
    }
  }

  @Test
  void everyControlHasAnAccessibleName() throws Exception {
    try (FormWindowDriver window = open(true)) {
      for (String def : List.of("Switch_Bin", "Desk", "Table")) {
        window.select(def);
        EventThread.edt(
            () ->
                assertThat(
                        Stream.of(window.form, window.problems, window.help)
                            .flatMap(FormWindowDriver::all)
                            .filter(FormPanelTest::control)
                            .filter(FormPanelTest::nameless))
                    .isEmpty());
      }
    }
  }

  private static boolean control(Component c) {
    boolean inside =
        c.getParent() instanceof JComboBox || c.getClass().getName().contains("Scroll");
    return c.isFocusable()
        && !inside
        && c.isShowing()
        && (c instanceof AbstractButton
            || c instanceof JTextComponent
            || c instanceof JComboBox
            || c instanceof JTable);
  }

  private static boolean nameless(Component c) {
    String name = ((Accessible) c).getAccessibleContext().getAccessibleName();
    return name == null || name.isBlank();
  }

  @Test
  void picturesOfTheRepositorysApartment() throws Exception {
    for (boolean dark : new boolean[] {false, true}) {
      try (FormWindowDriver window =
          new FormWindowDriver(Path.of("scenes", "apartment.x3d"), dark)) {
        String name =
            EventThread.get(
                () -> window.session.enrichment().switches().get(0).element().def().orElseThrow());
        window.select(name);
        JLabel polygons = (JLabel) window.named("Polygons of choice 1");
        Eventually.await(
            "the count", () -> EventThread.get(polygons::getText).endsWith("polygons"));
        window.screenshot("form-switch-" + (dark ? "dark" : "light"), dark ? 2 : 1);
        String area =
            EventThread.get(
                () -> window.session.enrichment().sensors().get(0).element().def().orElseThrow());
        window.select(area);
        window.click(window.named("On entering"));
        window.screenshot("form-sensor-" + (dark ? "dark" : "light"), 1);
      }
    }
  }
}
