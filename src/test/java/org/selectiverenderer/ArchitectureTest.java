package org.selectiverenderer;

import static com.tngtech.archunit.base.DescribedPredicate.not;
import static com.tngtech.archunit.core.domain.JavaAccess.Predicates.target;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.assignableTo;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAPackage;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAnyPackage;
import static com.tngtech.archunit.core.domain.properties.HasName.Predicates.name;
import static com.tngtech.archunit.core.domain.properties.HasName.Predicates.nameMatching;
import static com.tngtech.archunit.core.domain.properties.HasOwner.Predicates.With.owner;
import static com.tngtech.archunit.lang.conditions.ArchPredicates.are;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.fields;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;
import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.domain.JavaModifier;
import com.tngtech.archunit.core.domain.JavaPackage;
import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.core.importer.ImportOption.DoNotIncludeTests;
import com.tngtech.archunit.core.importer.Location;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchRule;
import java.io.FileDescriptor;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.jspecify.annotations.NullMarked;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.command.CommandProvider;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.x3d.model.ModelTranslator;

/**
 * Holds the code against ARCHITECTURE.md: its drawing of the modules, and those of its boundaries
 * that Maven cannot enforce.
 */
@AnalyzeClasses(
    packages = {"org.selectiverenderer", "org.web3d.x3d.sai"},
    importOptions = {DoNotIncludeTests.class, ArchitectureTest.WithoutTestSupport.class})
class ArchitectureTest {
  /** Leaves out what only tests use, such as the robot that drives windows. */
  static final class WithoutTestSupport implements ImportOption {
    @Override
    public boolean includes(Location location) {
      return !location.contains("/org/selectiverenderer/testing/");
    }
  }

  private static final String OURS = "org.selectiverenderer..";
  private static final String SAI = "org.web3d.x3d.sai..";

  /** Public for a reason that no use by another package shows. */
  private static final Set<String> PUBLIC_ALL_THE_SAME =
      Set.of(
          "org.selectiverenderer.browser.sai.EmbeddedBrowserFactory", // named, not called
          "org.selectiverenderer.study.headlog.HeadLog", // handed on without its name
          "org.selectiverenderer.browser.navigation.MotionRequest", // what a motion source of
          // others gives
          // what tests of other packages measure and plug in
          "org.selectiverenderer.tracker.Orientation",
          "org.selectiverenderer.tracker.emulator.InterTrax2Emulator",
          "org.selectiverenderer.tracker.emulator.PseudoTerminal",
          "org.selectiverenderer.validation.report.SarifReportWriter",
          // what Rhino's classes call once the build has written them anew
          "org.selectiverenderer.scriptengine.MeteredMethods",
          "org.selectiverenderer.scriptengine.MeteredStatics");

  private static final String[] DISPLAY = {
    "java.awt..", "javax.swing..", "com.jogamp..", "jogamp.."
  };

  /** Maven enforces what a module uses; the drawing says why the module may. */
  @Test
  void theDrawingShowsEveryModuleAboveWhatItsPomNames() throws IOException {
    List<MavenModule> modules = MavenModule.all();
    Map<String, Integer> rows = drawnRows();
    assertThat(rows.keySet())
        .as("modules in the drawing of ARCHITECTURE.md")
        .containsExactlyInAnyOrderElementsOf(modules.stream().map(MavenModule::name).toList());
    for (MavenModule module : modules) {
      assertThat(module.uses())
          .as("what %s uses lies below it in the drawing", module.name())
          .allSatisfy(used -> assertThat(rows.get(used)).isGreaterThan(rows.get(module.name())));
    }
  }

  @Test
  void noPackageIsInTwoModules() throws IOException {
    Map<String, Set<String>> homes = new TreeMap<>();
    for (MavenModule module : MavenModule.all()) {
      for (String name : module.packages()) {
        homes.computeIfAbsent(name, key -> new TreeSet<>()).add(module.name());
      }
    }
    homes.values().removeIf(modules -> modules.size() == 1);
    assertThat(homes).as("packages in several modules").isEmpty();
  }

  /** A name is clear inside its module; another module may use the word for a thing of its own. */
  @Test
  void noNameStandsForTwoThingsInAModule() throws IOException {
    Set<String> twice = new TreeSet<>();
    for (MavenModule module : MavenModule.all()) {
      Set<String> seen = new HashSet<>();
      for (Path source : module.mainSources()) {
        String name = source.getFileName().toString();
        if (!name.equals("package-info.java") && !seen.add(name)) {
          twice.add(module.name() + ": " + name);
        }
      }
    }
    assertThat(twice).isEmpty();
  }

  @ArchTest
  static final ArchRule everyPackageIsFreeOfCycles =
      slices().matching("org.selectiverenderer.(**)").should().beFreeOfCycles();

  @ArchTest
  static final ArchRule theStandardsInterfacesKnowNothingOfOurs =
      noClasses()
          .that()
          .resideInAPackage(SAI)
          .should()
          .dependOnClassesThat()
          .resideInAPackage(OURS);

  @ArchTest
  static final ArchRule theControllerRunsOnAnyBrowser =
      classes()
          .that()
          .resideInAPackage(of("control"))
          .should()
          .onlyDependOnClassesThat()
          .resideInAnyPackage(
              of("control"), of("schema"), of("sai"), SAI, "java..", "org.jspecify..");

  @ArchTest
  static final ArchRule openGlLivesInTheRenderer = onlyIn("render", "com.jogamp..", "jogamp..");

  @ArchTest
  static final ArchRule modelsAreReadAndReducedInOnePlace =
      onlyIn("models", "org.lwjgl.assimp..", "org.lwjgl.util..");

  @ArchTest
  static final ArchRule headsetsAreDrivenBehindOneDoor = onlyIn("openxr", "org.lwjgl.openxr..");

  /**
   * Models are read by LWJGL's libraries; the user's liblsl is called by the libffi in LWJGL, and
   * an OpenXR runtime by its loader.
   */
  @ArchTest
  static final ArchRule nativeMemoryIsTouchedBehindThreeDoors =
      noClasses()
          .that()
          .resideOutsideOfPackages(of("models"), of("lsl"), of("openxr"))
          .should()
          .dependOnClassesThat()
          .resideInAPackage("org.lwjgl..");

  @ArchTest
  static final ArchRule foreignFunctionsAreCalledInOnePlace =
      onlyIn("lsl", "org.lwjgl.system.libffi..");

  @ArchTest
  static final ArchRule soundIsReadAndPlayedInOnePlace = onlyIn("browser.sound", "javax.sound..");

  @ArchTest
  static final ArchRule mpegAudioIsDecodedInOnePlace = onlyIn("browser.sound", "javazoom..");

  @ArchTest
  static final ArchRule serialPortsAreOpenedInOnePlace = onlyIn("tracker.serial", "com.fazecast..");

  @ArchTest
  static final ArchRule displaysAndLightNeedNoRenderer =
      noClasses()
          .that()
          .resideInAnyPackage(of("hmd"), of("radiosity"), of("browser.camera"))
          .should()
          .dependOnClassesThat()
          .resideInAPackage(of("render"));

  @ArchTest
  static final ArchRule commandsAreChosenByTheEntryOnly =
      noClasses()
          .that()
          .resideInAPackage("org.selectiverenderer.cli.*..")
          .should()
          .dependOnClassesThat()
          .resideInAPackage("org.selectiverenderer.cli");

  @ArchTest
  static final ArchRule whatServersRunNeedsNoDisplay =
      noClasses()
          .that()
          .resideInAnyPackage(
              of("base"),
              of("formats"),
              of("apparatus"),
              of("models"),
              of("x3d"),
              of("geometry"),
              of("chart"),
              of("schema"),
              of("polygon"),
              of("statistics"),
              of("tracker"),
              of("lsl"),
              of("authoring"),
              of("validation"),
              of("radiosity"),
              of("modelling"),
              of("apartment"))
          .should()
          .dependOnClassesThat()
          .resideInAnyPackage(DISPLAY);

  @ArchTest
  static final ArchRule rhinoHasTwoDoors =
      noClasses()
          .that(
              are(resideInAPackage(OURS))
                  .and(
                      not(
                          resideInAnyPackage(
                              of("x3d.script"), of("browser.script"), of("scriptengine")))))
          .should()
          .dependOnClassesThat()
          .resideInAPackage("org.mozilla..");

  @ArchTest
  static final ArchRule sessionsAreKeptWithoutWindows =
      noClasses()
          .that()
          .resideInAPackage(of("study"))
          .should()
          .dependOnClassesThat()
          .resideInAnyPackage(DISPLAY);

  @ArchTest
  static final ArchRule theApartmentsRecipesAreModellingOnly =
      noClasses()
          .that()
          .resideInAnyPackage(
              of("apartment.kitchen"),
              of("apartment.lounge"),
              of("apartment.office"),
              of("apartment.furniture"))
          .should()
          .dependOnClassesThat(
              are(resideInAPackage(OURS))
                  .and(
                      not(
                          resideInAnyPackage(
                              of("modelling"),
                              of("geometry"),
                              of("apartment.materials"),
                              of("apartment.textures"),
                              of("apartment.kitchen"),
                              of("apartment.lounge"),
                              of("apartment.office"),
                              of("apartment.furniture")))));

  /** Generated files have the same bytes everywhere, which Math's functions do not promise. */
  @ArchTest
  static final ArchRule modelsAreMadeWithStrictMathematics =
      noClasses()
          .that()
          .resideInAnyPackage(of("modelling"), of("apartment"), of("radiosity"))
          .should()
          .callMethodWhere(
              target(owner(assignableTo(Math.class)))
                  .and(
                      target(
                          nameMatching(
                              "a?(sin|cos|tan)h?|atan2|exp|expm1|log|log10|log1p|pow|cbrt|hypot"))));

  /** The main classes of processes of their own, whose output goes to their parent. */
  private static final String CHILD_PROCESSES =
      "org\\.selectiverenderer\\.(models\\.importer\\.ModelImportMain|models\\.draco\\.DracoMain"
          + "|render\\.trial\\.ShaderTrialMain)";

  @ArchTest
  static final ArchRule onlyTheCommandLineTouchesTheProcess =
      noClasses()
          .that()
          .resideOutsideOfPackage(of("cli"))
          .and()
          .doNotHaveFullyQualifiedName("org.selectiverenderer.command.output.InterruptHandler")
          .and()
          .haveNameNotMatching(CHILD_PROCESSES)
          .should()
          .accessField(System.class, "out")
          .orShould()
          .accessField(System.class, "err")
          .orShould()
          .callMethod(System.class, "exit", int.class)
          .orShould()
          .callMethod(Runtime.class, "exit", int.class)
          .orShould()
          .callMethod(Runtime.class, "halt", int.class);

  /** The console makes control characters visible, so that no scene commands the terminal. */
  @ArchTest
  static final ArchRule allThatIsPrintedPassesTheConsole =
      noClasses()
          .that()
          .doNotHaveFullyQualifiedName("org.selectiverenderer.cli.Main")
          .and()
          .doNotHaveFullyQualifiedName("org.selectiverenderer.cli.Main$StandardErrorSilencer")
          .and()
          .doNotHaveFullyQualifiedName("org.selectiverenderer.cli.batch.BatchRunner")
          .and()
          .doNotHaveFullyQualifiedName("org.selectiverenderer.command.output.Console")
          .and()
          .haveNameNotMatching(CHILD_PROCESSES)
          .should()
          .accessField(FileDescriptor.class, "out")
          .orShould()
          .accessField(FileDescriptor.class, "err")
          .orShould()
          .accessField(System.class, "out")
          .orShould()
          .accessField(System.class, "err")
          .orShould()
          .callMethodWhere(target(owner(assignableTo(java.io.Console.class))))
          .orShould()
          .callConstructorWhere(target(owner(assignableTo(PrintStream.class))));

  /** Whoever prints colours escapes the other text himself. */
  @ArchTest
  static final ArchRule coloursArePrintedByTwo =
      noClasses()
          .that()
          .doNotHaveFullyQualifiedName("org.selectiverenderer.cli.CommandRunner")
          .and()
          .doNotHaveFullyQualifiedName("org.selectiverenderer.cli.author.ValidateCommand")
          .should()
          .callMethod(Console.class, "coloured", String.class);

  @ArchTest
  static final ArchRule nobodyPrintsAStackTraceToAUser =
      noClasses()
          .that()
          .doNotHaveSimpleName("FailureReporter") // for --debug
          .should()
          .callMethodWhere(target(name("printStackTrace"))); // of whatever exception

  /** The standard's own BrowserFactory is exempt: a static setter is its specified interface. */
  @ArchTest
  static final ArchRule noStaticState =
      fields()
          .that()
          .areStatic()
          .and()
          .areDeclaredInClassesThat()
          .resideInAPackage(OURS)
          .should()
          .beFinal();

  /** A door that nobody outside goes through is a wall: such a type is package-private. */
  @ArchTest
  static void publicTypesAreUsedByOtherPackages(JavaClasses ours) {
    Stream<String> inside =
        ours.stream()
            .filter(found -> found.getName().startsWith("org.selectiverenderer."))
            .filter(JavaClass::isTopLevelClass)
            .filter(found -> found.getModifiers().contains(JavaModifier.PUBLIC))
            .filter(found -> !found.isInterface()) // a lambda of another package may be one
            .filter(found -> found.tryGetMethod("main", String[].class).isEmpty())
            .filter(found -> !found.isAssignableTo(CommandProvider.class)) // found by ServiceLoader
            .filter(found -> !found.isAssignableTo(ModelTranslator.class)) // likewise
            .filter(found -> !isUsedFromOutside(found))
            .map(JavaClass::getName)
            .filter(found -> !PUBLIC_ALL_THE_SAME.contains(found));
    assertThat(inside).as("public types that no other package uses").isEmpty();
  }

  @ArchTest
  static void everyPackageIsDescribedAndNullMarked(JavaClasses ours) {
    Stream<String> undescribed =
        ours.stream()
            .map(JavaClass::getPackage)
            .distinct()
            .filter(found -> !isNullMarked(found))
            .map(JavaPackage::getName);
    assertThat(undescribed).as("packages without a @NullMarked package-info").isEmpty();
  }

  private static boolean isUsedFromOutside(JavaClass found) {
    return found.getDirectDependenciesToSelf().stream()
            .anyMatch(use -> !use.getOriginClass().getPackageName().equals(found.getPackageName()))
        || found.getAllSubclasses().stream().anyMatch(ArchitectureTest::isUsedFromOutside);
  }

  private static boolean isNullMarked(JavaPackage described) {
    return described
        .tryGetPackageInfo()
        .filter(info -> info.isAnnotatedWith(NullMarked.class))
        .isPresent();
  }

  /** Returns the row of each module in the drawing, from 0 at the top. */
  private static Map<String, Integer> drawnRows() throws IOException {
    String page = Files.readString(Path.of("ARCHITECTURE.md")).replace("\r\n", "\n");
    Matcher drawing = Pattern.compile("```layers\n(.*?)```", Pattern.DOTALL).matcher(page);
    assertThat(drawing.find()).as("ARCHITECTURE.md has a drawing of the layers").isTrue();
    Map<String, Integer> rows = new TreeMap<>();
    int row = 0;
    for (String line : drawing.group(1).lines().toList()) {
      for (String name : line.split("·")) {
        rows.put(name.strip(), row);
      }
      row++;
    }
    return rows;
  }

  /** A package and what lies within, as ArchUnit writes it. */
  private static String of(String name) {
    return "org.selectiverenderer." + name + "..";
  }

  private static ArchRule onlyIn(String user, String... libraries) {
    return noClasses()
        .that()
        .resideOutsideOfPackage(of(user))
        .should()
        .dependOnClassesThat()
        .resideInAnyPackage(libraries);
  }
}
