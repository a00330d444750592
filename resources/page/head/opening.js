// Pictures and what is said of a script that did not run are for readers without scripts: they are not laid out while the views
// open. They come back where a script fails, as an old browser says of one that it cannot read, and where the last script never came.
(function () {
    var page = document.documentElement;
    page.className = 'opening';
    function show() {
        page.className = page.className.replace('opening', '');
    }
    window.addEventListener('error', show);
    document.addEventListener('DOMContentLoaded', function () {
        show();
        if (page.className.indexOf('ran') < 0) {
            page.setAttribute('data-ready', 'unread');
        }
    });
})();
