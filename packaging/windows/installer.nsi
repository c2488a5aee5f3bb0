; The installer for Windows: for one user, without an administrator. packaging/parts/windows compiles it, and defines
;
;   VERSION, VERSION_NUMBERS   as the program says it, and as four numbers
;   PUBLISHER, SIZE            the first author, and the KiB that the program takes of a disk
;   FILES                      the folder in which are install.nsh and uninstall.nsh, the lists of all files
;   ICON, LICENSE, OUTPUT
;
; Beside the pages: /S asks nothing, /D=FOLDER (the last argument, without quotes) names the folder. It ends with 0
; where the program is installed, with 1 where the user cancels, and with 2 where it cannot be.
;
; Nothing is removed that was not installed: the uninstaller has a list of files, and removes folders only when they
; are empty, the program's own only where the installer made it. The user's settings stay.

Unicode true
Target amd64-unicode
SetCompressor /SOLID lzma
ManifestDPIAware true
RequestExecutionLevel user
; A file that cannot be written ends the installation; without questions it would be left out, and nobody would know.
AllowSkipFiles off

!include MUI2.nsh
!include LogicLib.nsh

!define NAME "Selective Renderer"
!define VIEWER "Selective Renderer.exe"
!define ENRICHER "Selective Renderer Enricher.exe"
!define REGISTRY_KEY "Software\SelectiveRenderer"
!define CLASSES "Software\Classes"
!define UNINSTALL "Software\Microsoft\Windows\CurrentVersion\Uninstall\SelectiveRenderer"

Name "${NAME}"
OutFile "${OUTPUT}"
; Without a space: Java 21 keeps only its own classes in the archive of classes where the path of the jar has one.
InstallDir "$LOCALAPPDATA\Programs\SelectiveRenderer"
; An update goes where the program is.
InstallDirRegKey HKCU "${REGISTRY_KEY}" "Folder"
BrandingText "${NAME} ${VERSION}"
VIProductVersion "${VERSION_NUMBERS}"
VIAddVersionKey /LANG=0 "ProductName" "${NAME}"
VIAddVersionKey /LANG=0 "ProductVersion" "${VERSION}"
VIAddVersionKey /LANG=0 "FileVersion" "${VERSION}"
VIAddVersionKey /LANG=0 "FileDescription" "Installer of the ${NAME}"
VIAddVersionKey /LANG=0 "CompanyName" "${PUBLISHER}"
VIAddVersionKey /LANG=0 "LegalCopyright" "MIT licence"

!define MUI_ICON "${ICON}"
!define MUI_UNICON "${ICON}"
!define MUI_ABORTWARNING
!define MUI_FINISHPAGE_RUN "$INSTDIR\${ENRICHER}"
!define MUI_FINISHPAGE_RUN_TEXT "$(RunEnricher)"
!define MUI_FINISHPAGE_NOREBOOTSUPPORT
!insertmacro MUI_PAGE_WELCOME
!insertmacro MUI_PAGE_LICENSE "${LICENSE}"
!insertmacro MUI_PAGE_COMPONENTS
!insertmacro MUI_PAGE_DIRECTORY
!insertmacro MUI_PAGE_INSTFILES
!insertmacro MUI_PAGE_FINISH
!insertmacro MUI_UNPAGE_CONFIRM
!insertmacro MUI_UNPAGE_INSTFILES
!insertmacro MUI_LANGUAGE "English"
!insertmacro MUI_LANGUAGE "Greek"

LangString ProgramSection ${LANG_ENGLISH} "Program"
LangString ProgramSection ${LANG_GREEK} "Πρόγραμμα"
LangString ProgramText ${LANG_ENGLISH} "The viewer, the enricher and the command line, with a Java of their own."
LangString ProgramText ${LANG_GREEK} "Η προβολή σκηνών, ο επεξεργαστής και η γραμμή εντολών, με δική τους Java."
LangString TypesSection ${LANG_ENGLISH} "Scene files"
LangString TypesSection ${LANG_GREEK} "Αρχεία σκηνών"
LangString TypesText ${LANG_ENGLISH} "Offers the viewer and the enricher for .x3d, .x3dv and .wrl files, and for the \
  compressed kinds .x3dz, .x3dvz and .wrz. A program that opens them already goes on doing so."
LangString TypesText ${LANG_GREEK} "Προτείνει την προβολή και τον επεξεργαστή για αρχεία .x3d, .x3dv και .wrl, και \
  για τις συμπιεσμένες μορφές .x3dz, .x3dvz και .wrz. Όποιο πρόγραμμα τα ανοίγει ήδη συνεχίζει να το κάνει."
LangString MenuSection ${LANG_ENGLISH} "Start menu"
LangString MenuSection ${LANG_GREEK} "Μενού Έναρξη"
LangString MenuText ${LANG_ENGLISH} "Shortcuts to the enricher and to the command line."
LangString MenuText ${LANG_GREEK} "Συντομεύσεις για τον επεξεργαστή και τη γραμμή εντολών."
LangString PathSection ${LANG_ENGLISH} "Command on PATH"
LangString PathSection ${LANG_GREEK} "Εντολή στο PATH"
LangString PathText ${LANG_ENGLISH} "Adds the program's folder to your PATH, so that terminals know the command \
  selective-renderer."
LangString PathText ${LANG_GREEK} "Προσθέτει τον φάκελο του προγράμματος στο PATH σας, ώστε τα τερματικά να γνωρίζουν την \
  εντολή selective-renderer."
LangString CommandLine ${LANG_ENGLISH} "Selective Renderer Command Line"
LangString CommandLine ${LANG_GREEK} "Selective Renderer - Γραμμή εντολών"
LangString RunEnricher ${LANG_ENGLISH} "Open the enricher"
LangString RunEnricher ${LANG_GREEK} "Άνοιγμα του επεξεργαστή"
LangString EditVerb ${LANG_ENGLISH} "Edit in the Selective Renderer Enricher"
LangString EditVerb ${LANG_GREEK} "Επεξεργασία στον Selective Renderer Enricher"
LangString StillRunning ${LANG_ENGLISH} "The Selective Renderer in $INSTDIR is running. Close its windows, then retry."
LangString StillRunning ${LANG_GREEK} "Το Selective Renderer στον φάκελο $INSTDIR εκτελείται. Κλείστε τα παράθυρά του \
  και δοκιμάστε ξανά."
LangString NotWritable ${LANG_ENGLISH} "The folder $INSTDIR cannot be written to. Choose another one."
LangString NotWritable ${LANG_GREEK} "Δεν είναι δυνατή η εγγραφή στον φάκελο $INSTDIR. Επιλέξτε άλλον."
LangString OldStays ${LANG_ENGLISH} "The version that is installed could not be removed, so nothing was changed. Uninstall \
  it in Windows' settings, then retry."
LangString OldStays ${LANG_GREEK} "Δεν ήταν δυνατή η κατάργηση της εγκατεστημένης έκδοσης και τίποτα δεν άλλαξε. \
  Καταργήστε την από τις ρυθμίσεις των Windows και δοκιμάστε ξανά."
LangString NotComplete ${LANG_ENGLISH} "Not all files could be written to $INSTDIR. Make room or choose another folder, then \
  retry."
LangString NotComplete ${LANG_GREEK} "Δεν ήταν δυνατή η εγγραφή όλων των αρχείων στον φάκελο $INSTDIR. Ελευθερώστε χώρο ή \
  επιλέξτε άλλον φάκελο και δοκιμάστε ξανά."
LangString NotOnPath ${LANG_ENGLISH} "The program is installed, but your PATH could not be changed. Add the folder $INSTDIR \
  to it in Windows' settings."
LangString NotOnPath ${LANG_GREEK} "Το πρόγραμμα εγκαταστάθηκε, αλλά δεν ήταν δυνατή η αλλαγή του PATH σας. Προσθέστε σε \
  αυτό τον φάκελο $INSTDIR από τις ρυθμίσεις των Windows."

; A library that a program uses cannot be opened for writing.
!macro AskToClose un
Function ${un}AskToClose
  ${Do}
    ${IfNot} ${FileExists} "$INSTDIR\runtime\bin\server\jvm.dll"
      Return
    ${EndIf}
    ClearErrors
    FileOpen $0 "$INSTDIR\runtime\bin\server\jvm.dll" a
    ${IfNot} ${Errors}
      FileClose $0
      Return
    ${EndIf}
    MessageBox MB_RETRYCANCEL|MB_ICONEXCLAMATION "$(StillRunning)" /SD IDCANCEL IDRETRY again
      SetErrorLevel 2
      Abort "$(StillRunning)"
    again:
  ${Loop}
FunctionEnd
!macroend
!insertmacro AskToClose ""
!insertmacro AskToClose "un."

; --- Install --------------------------------------------------------------------------------------

Var FolderIsOurs ; Whether the program's folder was made by an installer.

Section "$(ProgramSection)" Program
  SectionIn RO
  Call AskToClose
  ReadRegDWORD $FolderIsOurs HKCU "${REGISTRY_KEY}" "MadeFolder"
  ReadRegStr $1 HKCU "${REGISTRY_KEY}" "Folder"
  StrCpy $3 $FolderIsOurs ; That of the version before.
  ${If} $1 != $INSTDIR
    StrCpy $FolderIsOurs 0
  ${EndIf}
  ${IfNot} ${FileExists} "$INSTDIR\*.*"
    StrCpy $FolderIsOurs 1
  ${EndIf}

  ClearErrors
  SetOutPath "$INSTDIR"
  FileOpen $0 "$INSTDIR\selective-renderer.test" w
  ${If} ${Errors}
    MessageBox MB_OK|MB_ICONSTOP "$(NotWritable)" /SD IDOK
    SetErrorLevel 2
    Abort "$(NotWritable)"
  ${EndIf}
  FileClose $0
  Delete "$INSTDIR\selective-renderer.test"

  ; The version before, wherever it is; its uninstaller knows its files, and runs where it lies.
  ${If} $1 != ""
  ${AndIf} ${FileExists} "$1\uninstall.exe"
    ExecWait '"$1\uninstall.exe" /S /UPDATE _?=$1' $2
    ${If} $2 != 0
      MessageBox MB_OK|MB_ICONSTOP "$(OldStays)" /SD IDOK
      SetErrorLevel 2
      Abort "$(OldStays)"
    ${EndIf}
    Delete "$1\uninstall.exe"
    ${If} $1 != $INSTDIR
    ${AndIf} $3 = 1
      RMDir "$1"
    ${EndIf}
  ${EndIf}

  SetOverwrite on
  ClearErrors
  !include "${FILES}/install.nsh"
  SetOutPath "$INSTDIR"
  WriteUninstaller "$INSTDIR\uninstall.exe"
  ${If} ${Errors}
    MessageBox MB_OK|MB_ICONSTOP "$(NotComplete)" /SD IDOK
    SetErrorLevel 2
    Abort "$(NotComplete)"
  ${EndIf}

  WriteRegStr HKCU "${REGISTRY_KEY}" "Folder" "$INSTDIR"
  WriteRegDWORD HKCU "${REGISTRY_KEY}" "MadeFolder" $FolderIsOurs
  WriteRegStr HKCU "${UNINSTALL}" "DisplayName" "${NAME}"
  WriteRegStr HKCU "${UNINSTALL}" "DisplayVersion" "${VERSION}"
  WriteRegStr HKCU "${UNINSTALL}" "DisplayIcon" "$INSTDIR\${VIEWER}"
  WriteRegStr HKCU "${UNINSTALL}" "Publisher" "${PUBLISHER}"
  WriteRegStr HKCU "${UNINSTALL}" "InstallLocation" "$INSTDIR"
  WriteRegStr HKCU "${UNINSTALL}" "UninstallString" '"$INSTDIR\uninstall.exe"'
  WriteRegStr HKCU "${UNINSTALL}" "QuietUninstallString" '"$INSTDIR\uninstall.exe" /S'
  WriteRegDWORD HKCU "${UNINSTALL}" "EstimatedSize" ${SIZE}
  WriteRegDWORD HKCU "${UNINSTALL}" "NoModify" 1
  WriteRegDWORD HKCU "${UNINSTALL}" "NoRepair" 1

  ; Its first start makes the archive of classes.
  nsExec::Exec /TIMEOUT=180000 '"$INSTDIR\selective-renderer.exe" --version'
  Pop $0
SectionEnd

; A type of files: its extension and its name. $R0 becomes what opens the extension now, for this user or for all.
!macro Type EXTENSION DESCRIPTION
  WriteRegStr HKCU "${CLASSES}\SelectiveRenderer.${EXTENSION}" "" "${DESCRIPTION}"
  WriteRegStr HKCU "${CLASSES}\SelectiveRenderer.${EXTENSION}\DefaultIcon" "" "$INSTDIR\${VIEWER},0"
  WriteRegStr HKCU "${CLASSES}\SelectiveRenderer.${EXTENSION}\shell\open\command" "" '"$INSTDIR\${VIEWER}" "%1"'
  WriteRegStr HKCU "${CLASSES}\SelectiveRenderer.${EXTENSION}\shell\enrich" "" "$(EditVerb)"
  WriteRegStr HKCU "${CLASSES}\SelectiveRenderer.${EXTENSION}\shell\enrich\command" "" '"$INSTDIR\${ENRICHER}" "%1"'
  WriteRegNone HKCU "${CLASSES}\.${EXTENSION}\OpenWithProgids" "SelectiveRenderer.${EXTENSION}"
  ReadRegStr $R0 HKCU "${CLASSES}\.${EXTENSION}" ""
  ${If} $R0 == ""
    ReadRegStr $R0 HKLM "${CLASSES}\.${EXTENSION}" ""
  ${EndIf}
  ${If} $R0 == ""
    WriteRegStr HKCU "${CLASSES}\.${EXTENSION}" "" "SelectiveRenderer.${EXTENSION}"
  ${EndIf}
  WriteRegStr HKCU "${CLASSES}\Applications\${VIEWER}\SupportedTypes" ".${EXTENSION}" ""
  WriteRegStr HKCU "${CLASSES}\Applications\${ENRICHER}\SupportedTypes" ".${EXTENSION}" ""
  WriteRegStr HKCU "${REGISTRY_KEY}\Capabilities\FileAssociations" ".${EXTENSION}" "SelectiveRenderer.${EXTENSION}"
!macroend

; As Windows wants it: offered in "Open with" and in the settings, and the default only where there is none.
Section "$(TypesSection)" Types
  !insertmacro Type "x3d" "X3D scene"
  !insertmacro Type "x3dz" "X3D scene (compressed)"
  !insertmacro Type "x3dv" "X3D scene (ClassicVRML)"
  !insertmacro Type "x3dvz" "X3D scene (ClassicVRML, compressed)"
  !insertmacro Type "wrl" "VRML scene"
  !insertmacro Type "wrz" "VRML scene (compressed)"
  WriteRegStr HKCU "${CLASSES}\Applications\${VIEWER}" "FriendlyAppName" "Selective Renderer"
  WriteRegStr HKCU "${CLASSES}\Applications\${VIEWER}\shell\open\command" "" '"$INSTDIR\${VIEWER}" "%1"'
  WriteRegStr HKCU "${CLASSES}\Applications\${ENRICHER}" "FriendlyAppName" "Selective Renderer Enricher"
  WriteRegStr HKCU "${CLASSES}\Applications\${ENRICHER}\shell\open\command" "" '"$INSTDIR\${ENRICHER}" "%1"'
  WriteRegStr HKCU "${REGISTRY_KEY}\Capabilities" "ApplicationName" "${NAME}"
  WriteRegStr HKCU "${REGISTRY_KEY}\Capabilities" "ApplicationDescription" "Shows X3D and VRML scenes"
  WriteRegStr HKCU "Software\RegisteredApplications" "${NAME}" "${REGISTRY_KEY}\Capabilities"
  WriteRegDWORD HKCU "${REGISTRY_KEY}" "SceneFiles" 1
  System::Call 'shell32::SHChangeNotify(i 0x08000000, i 0, p 0, p 0)'
SectionEnd

Section "$(MenuSection)" Menu
  SetOutPath "$DOCUMENTS"
  CreateDirectory "$SMPROGRAMS\${NAME}"
  CreateShortcut "$SMPROGRAMS\${NAME}\Selective Renderer.lnk" "$INSTDIR\${VIEWER}"
  CreateShortcut "$SMPROGRAMS\${NAME}\Selective Renderer Enricher.lnk" "$INSTDIR\${ENRICHER}"
  CreateShortcut "$SMPROGRAMS\${NAME}\$(CommandLine).lnk" "$SYSDIR\cmd.exe" \
    '/k set "PATH=$INSTDIR;%PATH%" & selective-renderer --help' "$INSTDIR\selective-renderer.exe"
  SetOutPath "$INSTDIR"
  WriteRegDWORD HKCU "${REGISTRY_KEY}" "StartMenu" 1
SectionEnd

Section "$(PathSection)" Path
  nsExec::Exec '"$INSTDIR\app\user-path.exe" add "$INSTDIR"'
  Pop $0
  ${If} $0 == 0
    WriteRegDWORD HKCU "${REGISTRY_KEY}" "OnPath" 1
  ${Else}
    MessageBox MB_OK|MB_ICONEXCLAMATION "$(NotOnPath)" /SD IDOK
    SetErrorLevel 2
  ${EndIf}
SectionEnd

; What the user leaves out is written down, and an update leaves it out too (.onInit).
!macro WriteLeftOut VALUE SECTION
  ${IfNot} ${SectionIsSelected} ${SECTION}
    WriteRegDWORD HKCU "${REGISTRY_KEY}" "${VALUE}" 0
  ${EndIf}
!macroend
Section
  !insertmacro WriteLeftOut "SceneFiles" ${Types}
  !insertmacro WriteLeftOut "StartMenu" ${Menu}
  !insertmacro WriteLeftOut "OnPath" ${Path}
SectionEnd

!insertmacro MUI_FUNCTION_DESCRIPTION_BEGIN
  !insertmacro MUI_DESCRIPTION_TEXT ${Program} "$(ProgramText)"
  !insertmacro MUI_DESCRIPTION_TEXT ${Types} "$(TypesText)"
  !insertmacro MUI_DESCRIPTION_TEXT ${Menu} "$(MenuText)"
  !insertmacro MUI_DESCRIPTION_TEXT ${Path} "$(PathText)"
!insertmacro MUI_FUNCTION_DESCRIPTION_END

!macro UnselectLeftOut VALUE SECTION
  ClearErrors
  ReadRegDWORD $0 HKCU "${REGISTRY_KEY}" "${VALUE}"
  ${IfNot} ${Errors}
  ${AndIf} $0 = 0
    !insertmacro UnselectSection ${SECTION}
  ${EndIf}
!macroend
Function .onInit
  !insertmacro UnselectLeftOut "SceneFiles" ${Types}
  !insertmacro UnselectLeftOut "StartMenu" ${Menu}
  !insertmacro UnselectLeftOut "OnPath" ${Path}
FunctionEnd

; --- Uninstall ------------------------------------------------------------------------------------

!macro UnType EXTENSION
  DeleteRegKey HKCU "${CLASSES}\SelectiveRenderer.${EXTENSION}"
  DeleteRegValue HKCU "${CLASSES}\.${EXTENSION}\OpenWithProgids" "SelectiveRenderer.${EXTENSION}"
  ReadRegStr $R0 HKCU "${CLASSES}\.${EXTENSION}" ""
  ${If} $R0 == "SelectiveRenderer.${EXTENSION}"
    DeleteRegValue HKCU "${CLASSES}\.${EXTENSION}" ""
  ${EndIf}
  ; What others wrote there stays.
  DeleteRegKey /ifempty HKCU "${CLASSES}\.${EXTENSION}\OpenWithProgids"
  DeleteRegKey /ifempty HKCU "${CLASSES}\.${EXTENSION}"
!macroend

Section "Uninstall"
  Call un.AskToClose
  nsExec::Exec '"$INSTDIR\app\user-path.exe" remove "$INSTDIR"'
  Pop $0

  !insertmacro UnType "x3d"
  !insertmacro UnType "x3dz"
  !insertmacro UnType "x3dv"
  !insertmacro UnType "x3dvz"
  !insertmacro UnType "wrl"
  !insertmacro UnType "wrz"
  DeleteRegKey HKCU "${CLASSES}\Applications\${VIEWER}"
  DeleteRegKey HKCU "${CLASSES}\Applications\${ENRICHER}"
  DeleteRegValue HKCU "Software\RegisteredApplications" "${NAME}"
  System::Call 'shell32::SHChangeNotify(i 0x08000000, i 0, p 0, p 0)'

  ; What the program has unpacked for itself, and can unpack again.
  RMDir /r "$LOCALAPPDATA\selective-renderer\natives"
  RMDir "$LOCALAPPDATA\selective-renderer"

  Delete "$SMPROGRAMS\${NAME}\*.lnk"
  RMDir "$SMPROGRAMS\${NAME}"

  Delete "$INSTDIR\app\classes-*.jsa*"
  !include "${FILES}/uninstall.nsh"
  Delete "$INSTDIR\uninstall.exe"
  ReadRegDWORD $FolderIsOurs HKCU "${REGISTRY_KEY}" "MadeFolder"
  SetOutPath "$TEMP"
  ${If} $FolderIsOurs = 1
    RMDir "$INSTDIR"
  ${EndIf}
  DeleteRegKey HKCU "${UNINSTALL}"
  DeleteRegKey HKCU "${REGISTRY_KEY}"
SectionEnd
