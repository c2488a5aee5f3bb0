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
import com.tngtech.archunit.core.domain.JavaPackage;
import com.tngtech.archunit.core.importer.ImportOption.DoNotIncludeTests;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchRule;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.jspecify.annotations.NullMarked;

/** The rules of ARCHITECTURE.md: which package may use which. */
@AnalyzeClasses(
    packages = {"org.selectiverenderer", "org.web3d.x3d.sai"},
    importOptions = DoNotIncludeTests.class)
class ArchitectureTest {
  private static final String OURS = "org.selectiverenderer..";
  private static final String SAI = "org.web3d.x3d.sai..";

  /**
   * Top-level packages that may be; a new one is added here when its rules have been thought of.
   */
  private static final Set<String> TOP_LEVEL =
      Set.of(
          "apartment",
          "app",
          "bench",
          "cli",
          "control",
          "chart",
          "csv",
          "document",
          "enricher",
          "experiment",
          "hmd",
          "modelling",
          "polygon",
          "radiosity",
          "runtime",
          "schema",
          "statistics",
          "tracker",
          "validation",
          "x3d");

  @ArchTest
  static final ArchRule theStandardsInterfacesKnowNothingOfOurs =
      noClasses()
          .that()
          .resideInAPackage(SAI)
          .should()
          .dependOnClassesThat()
          .resideInAPackage(OURS)
          .allowEmptyShould(true);

  @ArchTest
  static final ArchRule theControllerSeesABrowserOnlyThroughTheSai =
      onlyUses(of("control"), of("control"), of("schema"), SAI, "java..", "org.jspecify..");

  @ArchTest static final ArchRule theLanguageUsesNothingElseOfOurs = onlyUsesOfOurs("x3d", "x3d");

  @ArchTest
  static final ArchRule theLanguageDoesNotUseItsGeometry =
      noClasses()
          .that(are(resideInAPackage(of("x3d"))).and(not(resideInAPackage(of("x3d.geometry")))))
          .should()
          .dependOnClassesThat()
          .resideInAPackage(of("x3d.geometry"));

  @ArchTest
  static final ArchRule theVocabularyUsesTheLanguageOnly =
      onlyUsesOfOurs("schema", "schema", "x3d");

  @ArchTest
  static final ArchRule polygonStatisticsUseFilesAndTheVocabularyOnly =
      onlyUsesOfOurs("polygon.statistics", "polygon.statistics", "x3d", "schema");

  @ArchTest static final ArchRule tablesUseTheLanguageOnly = onlyUsesOfOurs("csv", "csv", "x3d");

  @ArchTest
  static final ArchRule chartsAreDrawnWithFontsOnly =
      onlyUsesOfOurs("chart", "chart", "x3d.geometry.text");

  @ArchTest
  static final ArchRule statisticsUseTablesAndChartsOnly =
      onlyUsesOfOurs("statistics", "statistics", "chart", "csv", "x3d");

  @ArchTest
  static final ArchRule theValidatorUsesFilesTheVocabularyAndCountsOnly =
      onlyUsesOfOurs("validation", "validation", "polygon.statistics", "schema", "x3d");

  @ArchTest
  static final ArchRule thePolygonCountProcessUsesTheLanguageOnly =
      onlyUsesOfOurs("polygon", "polygon", "x3d", "schema");

  @ArchTest
  static final ArchRule documentsAreEditedWithoutARuntime =
      onlyUsesOfOurs("document", "document", "polygon", "schema", "x3d");

  @ArchTest
  static final ArchRule nativeLibrariesOfModelsLiveInThePolygonCountProcess =
      noClasses()
          .that()
          .resideOutsideOfPackage(of("polygon"))
          .should()
          .dependOnClassesThat()
          .resideInAPackage("org.lwjgl..");

  @ArchTest
  static final ArchRule theRuntimeKnowsNeitherControllerNorCommandLine =
      noClasses()
          .that()
          .resideInAPackage(of("runtime"))
          .should()
          .dependOnClassesThat()
          .resideInAnyPackage(of("control"), of("cli"))
          .allowEmptyShould(true);

  @ArchTest
  static final ArchRule nobodyUsesTheCommandLine =
      noClasses()
          .that()
          .resideOutsideOfPackage(of("cli"))
          .should()
          .dependOnClassesThat()
          .resideInAPackage(of("cli"));

  @ArchTest
  static final ArchRule onlyProgramsUseTheProgram =
      noClasses()
          .that()
          .resideOutsideOfPackages(of("cli"), of("bench"), of("app"), of("enricher"))
          .should()
          .dependOnClassesThat()
          .resideInAPackage(of("app"));

  @ArchTest
  static final ArchRule openGlLivesInTheRenderer =
      noClasses()
          .that()
          .resideOutsideOfPackage(of("runtime.render"))
          .should()
          .dependOnClassesThat()
          .resideInAnyPackage("com.jogamp..", "jogamp..");

  @ArchTest
  static final ArchRule whatCiRunsLoadsNeitherAwtNorOpenGl =
      noClasses()
          .that()
          .resideInAnyPackage(
              of("validation"),
              of("chart"),
              of("csv"),
              of("statistics"),
              of("tracker"),
              of("polygon"),
              of("modelling"),
              of("apartment"),
              of("radiosity"),
              of("schema"),
              of("document"),
              of("x3d"))
          .should()
          .dependOnClassesThat()
          .resideInAnyPackage("java.awt..", "javax.swing..", "com.jogamp..", "jogamp..");

  @ArchTest
  static final ArchRule sessionsAreKeptWithoutWindows =
      noClasses()
          .that(
              are(resideInAPackage(of("experiment")))
                  .and(not(resideInAPackage(of("experiment.window")))))
          .should()
          .dependOnClassesThat()
          .resideInAnyPackage("java.awt..", "javax.swing..", "com.jogamp..", "jogamp..");

  @ArchTest
  static final ArchRule theModellingToolkitUsesGeometryOnly =
      onlyUsesOfOurs("modelling", "modelling", "x3d.geometry");

  @ArchTest
  static final ArchRule theApartmentIsMadeWithoutARuntime =
      onlyUsesOfOurs("apartment", "apartment", "modelling", "polygon", "schema", "x3d");

  @ArchTest
  static final ArchRule radiosityKnowsNoRenderer =
      onlyUsesOfOurs(
          "radiosity",
          "radiosity",
          "polygon",
          "schema",
          "x3d",
          "runtime.instance",
          "runtime.loading",
          "runtime.navigation",
          "runtime.nodes",
          "runtime.scene");

  @ArchTest
  static final ArchRule theApartmentsRecipesAreModellingOnly =
      noClasses()
          .that()
          .resideInAnyPackage(
              of("apartment.kitchen"), of("apartment.lounge"), of("apartment.office"))
          .should()
          .dependOnClassesThat(
              are(resideInAPackage(OURS))
                  .and(
                      not(
                          resideInAnyPackage(
                              of("modelling"),
                              of("apartment.kitchen"),
                              of("apartment.lounge"),
                              of("apartment.office")))));

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

  @ArchTest
  static final ArchRule tablesUseTheLanguagesProblemsOnly = onlyUsesOfOurs("csv", "csv", "x3d");

  @ArchTest
  static final ArchRule trackersKnowNothingOfScenes =
      onlyUsesOfOurs("tracker", "tracker", "csv", "x3d");

  @ArchTest
  static final ArchRule serialPortsAreOpenedInOnePlace =
      noClasses()
          .that()
          .resideOutsideOfPackage(of("tracker.serial"))
          .should()
          .dependOnClassesThat()
          .resideInAPackage("com.fazecast..");

  @ArchTest
  static final ArchRule thePackagesHaveNoCycles =
      slices().matching("org.selectiverenderer.(*)..").should().beFreeOfCycles();

  @ArchTest
  static final ArchRule onlyTheCommandLineTouchesTheProcess =
      noClasses()
          .that()
          .resideOutsideOfPackage(of("cli"))
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

  @ArchTest
  static final ArchRule nobodyPrintsAStackTraceToAUser =
      noClasses()
          .that()
          .doNotHaveFullyQualifiedName("org.selectiverenderer.cli.FailureReport") // for --debug
          .should()
          .callMethodWhere(
              target(owner(assignableTo(Throwable.class))).and(target(name("printStackTrace"))));

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

  @ArchTest
  static void everyPackageIsKnown(JavaClasses ours) {
    Set<String> found =
        ours.stream()
            .map(JavaClass::getPackageName)
            .filter(name -> name.startsWith("org.selectiverenderer"))
            .map(name -> (name + ".").split("\\.")[2])
            .collect(Collectors.toCollection(TreeSet::new));
    assertThat(found).isNotEmpty().isSubsetOf(TOP_LEVEL);
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

  private static boolean isNullMarked(JavaPackage described) {
    return described
        .tryGetPackageInfo()
        .filter(info -> info.isAnnotatedWith(NullMarked.class))
        .isPresent();
  }

  /** A package and what lies within, as ArchUnit writes it. */
  private static String of(String name) {
    return "org.selectiverenderer." + name + "..";
  }

  private static ArchRule onlyUses(String user, String... used) {
    return classes()
        .that()
        .resideInAPackage(user)
        .should()
        .onlyDependOnClassesThat()
        .resideInAnyPackage(used)
        .allowEmptyShould(true);
  }

  private static ArchRule onlyUsesOfOurs(String user, String... used) {
    String[] allowed = Stream.of(used).map(ArchitectureTest::of).toArray(String[]::new);
    return noClasses()
        .that()
        .resideInAPackage(of(user))
        .should()
        .dependOnClassesThat(
            are(resideInAnyPackage(OURS, SAI)).and(not(resideInAnyPackage(allowed))))
        .allowEmptyShould(true);
  }
}
